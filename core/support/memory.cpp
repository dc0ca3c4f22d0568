#include "core/support/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr std::uintmax_t UNNOTICED = std::uintmax_t{64} << 20;

}  // namespace

std::optional<std::uintmax_t> free_memory() {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (std::uintmax_t kibibytes = 0; file >> name >> kibibytes;) {
        if (name == "MemAvailable:") return kibibytes << 10;
        std::getline(file, unit);
    }
    return std::nullopt;
}

std::uintmax_t own_memory() {
    std::ifstream file("/proc/self/statm");  // in pages: size, resident, shared, text, library, data
    std::uintmax_t pages = 0;
    for (int i = 0; i < 6; ++i)
        if (!(file >> pages)) return 0;
    return pages * static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
}

std::string memory_text(std::uintmax_t bytes) {
    constexpr double MIB = 1 << 20;
    const double mib = static_cast<double>(bytes) / MIB;
    if (mib >= 1000) return fmt::format("{:.1f} GiB", mib / 1024);
    return mib >= 1 ? fmt::format("{:.0f} MiB", mib) : fmt::format("{:.0f} KiB", std::ceil(mib * 1024));
}

void require_memory(std::uintmax_t bytes, const std::string& what, const std::string& remedy) {
    if (bytes < UNNOTICED) return;
    const auto free = free_memory();
    if (free && bytes > *free)
        throw Error(fmt::format("{} takes {} of memory, more than the {} that are free; {}.", what,
                                memory_text(bytes), memory_text(*free), remedy));
}

}  // namespace momentscope
