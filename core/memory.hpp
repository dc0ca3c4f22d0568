// memory.hpp -- how much memory is free, before much of it is taken.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace momentscope {

/// Bytes that the system can give without swapping; nullopt where it does not say.
std::optional<std::uintmax_t> free_memory();

/// Bytes that this process holds and may write to; 0 where the system does not say.
std::uintmax_t own_memory();

/// "1.5 GiB", "20 MiB", "3 KiB".
std::string memory_text(std::uintmax_t bytes);

/// Throws Error when so many bytes are more than are free: "WHAT takes 3.0 GiB of memory, more than the
/// 1.0 GiB that are free; REMEDY." What is below 64 MiB is not looked at.
void require_memory(std::uintmax_t bytes, const std::string& what, const std::string& remedy);

}  // namespace momentscope
