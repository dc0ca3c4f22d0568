# Included if the standard library is libc++ on Linux, where the C++ libraries of the system are built for that of g++. A
# std::string or a std::vector cannot be passed to them. C interfaces can be called (Assimp, CLP), and so can C++ functions
# without types of the standard library (Dear ImGui). The rest is compiled here.

# Both standard libraries are in one process then. They have some symbols in common, such as those that throw exceptions, so the
# program keeps its own to itself.
string(APPEND CMAKE_EXE_LINKER_FLAGS " -static-libstdc++ -Wl,--exclude-libs,ALL")

set(FMT_LIBRARY fmt::fmt-header-only)

# Boost 1.74 derives from std::unary_function, which libc++ does not have in C++20.
add_compile_definitions(BOOST_NO_CXX98_FUNCTION_BASE)

# Only plain types pass between the program and this module.
set(PICTURES_FLAGS -stdlib=libstdc++)

# The functions of Dear ImGui that edit a std::string.
add_library(imgui_stdlib STATIC cmake/imgui_stdlib.cpp)
target_include_directories(imgui_stdlib SYSTEM PRIVATE ${IMGUI_INCLUDE_DIRS})
target_link_libraries(PkgConfig::IMGUI INTERFACE imgui_stdlib)

# GoogleTest from the source in Debian's package googletest.
if(BUILD_TESTING)
    set(GTEST_SOURCE /usr/src/googletest/googletest)
    if(NOT EXISTS ${GTEST_SOURCE}/src/gtest-all.cc)
        message(FATAL_ERROR "With libc++ the tests need the source of GoogleTest; install the package googletest.")
    endif()
    add_library(gtest STATIC ${GTEST_SOURCE}/src/gtest-all.cc)
    target_include_directories(gtest PRIVATE ${GTEST_SOURCE})
    target_include_directories(gtest SYSTEM PUBLIC ${GTEST_SOURCE}/include)
    add_library(GTest::gtest ALIAS gtest)
endif()
