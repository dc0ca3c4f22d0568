// serve_main.cpp -- the main function of every test program. With --serve it runs the tests named on standard
// input, one per line. So scripts/run-tests can distribute tests to processes that load their libraries and
// compile their shaders only once.
#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>

namespace {

constexpr char END_OF_TEST = '\x1e';  // begins the line with the result of a test

const char* outcome(const testing::UnitTest& run, int code) {
    if (code != 0) return "failed";
    if (run.test_to_run_count() == 0) return "unknown";
    return run.skipped_test_count() > 0 ? "skipped" : "passed";
}

void serve() {
    std::string name;
    while (std::getline(std::cin, name)) {
        GTEST_FLAG_SET(filter, name);
        const int code = RUN_ALL_TESTS();
        std::cout.flush();
        std::printf("\n%c%s\n", END_OF_TEST, outcome(*testing::UnitTest::GetInstance(), code));
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool serving = argc == 2 && std::string_view(argv[1]) == "--serve";
    GTEST_FLAG_SET(brief, serving);
    testing::InitGoogleTest(&argc, argv);
    if (!serving) return RUN_ALL_TESTS();
    serve();
    return 0;
}
