// memory.hpp -- checks how much memory is free before the program takes much.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace momentscope {

/// The bytes that the system can give without swapping; nullopt if it does not tell.
std::optional<std::uintmax_t> free_memory();

/// The bytes that this process holds and may write to; 0 if the system does not tell.
std::uintmax_t own_memory();

/// A number of bytes as text: "1.5 GiB", "20 MiB", "3 KiB".
std::string memory_text(std::uintmax_t bytes);

/// Throws Error if this is more than the free memory: "WHAT takes 3.0 GiB of memory, more than the 1.0 GiB
/// that are free; REMEDY." Less than 64 MiB is not checked.
void require_memory(std::uintmax_t bytes, const std::string& what, const std::string& remedy);

}  // namespace momentscope
