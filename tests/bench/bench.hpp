// bench.hpp -- code that the benchmarks share.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/support/error.hpp"

namespace momentscope {

constexpr glm::ivec2 BENCH_SIZE(1280, 720);
constexpr float BENCH_OPACITY = 0.4f;  // only for mesh files

inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// The main function of a benchmark. The first argument is the number of repetitions [standard]; the second
/// one lists techniques, otherwise all are measured. Prints the sentence of an Error and returns 1.
inline int bench_main(int argc, char** argv, const char* name, int standard,
                      void (*run)(int repetitions, std::string_view only)) {
    int repetitions = standard;
    if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), repetitions);
    try {
        run(std::max(repetitions, 1), argc > 2 ? argv[2] : "");
        return 0;
    } catch (const Error& error) {
        std::fputs(fmt::format("{}: {}\n", name, error.what()).c_str(), stderr);
        return 1;
    }
}

/// Does the second argument list the technique?
inline bool is_wanted(std::string_view only, std::string_view technique) {
    return only.empty() || only.find(technique) != only.npos;
}

}  // namespace momentscope
