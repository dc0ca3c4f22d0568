// library.cpp -- wraps functions of Assimp. The linker redirects their calls to this file (--wrap in
// CMakeLists.txt).
#include "tests/fuzz/library.hpp"

#include <assimp/cfileio.h>
#include <assimp/scene.h>
#include <sys/resource.h>
#include <sys/time.h>

namespace momentscope::fuzz {

namespace {

Library own;
Library* noted = &own;

/// The library runs during the lifetime of this object.
struct InLibrary {
    InLibrary() {
        noted->runs = true;
        limit_time(LIBRARY_SECONDS);
    }
    ~InLibrary() {
        limit_time(MAX_SECONDS);
        noted->memory = most_memory();
        noted->runs = false;
    }
    InLibrary(const InLibrary&) = delete;
    InLibrary& operator=(const InLibrary&) = delete;
};

}  // namespace

void note_library_in(Library& library) {
    noted = &library;
}

void limit_time(int seconds) {
    const itimerval timer{{}, {seconds, 0}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

long most_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

}  // namespace momentscope::fuzz

using momentscope::fuzz::InLibrary;

// names that the linker requires
extern "C" {
const aiScene* __real_aiImportFileEx(const char*, unsigned, aiFileIO*);
const aiScene* __wrap_aiImportFileEx(const char* file, unsigned flags, aiFileIO* files) {
    const InLibrary in;
    return __real_aiImportFileEx(file, flags, files);
}

const aiScene* __real_aiApplyPostProcessing(const aiScene*, unsigned);
const aiScene* __wrap_aiApplyPostProcessing(const aiScene* scene, unsigned flags) {
    const InLibrary in;
    return __real_aiApplyPostProcessing(scene, flags);
}

void __real_aiReleaseImport(const aiScene*);
void __wrap_aiReleaseImport(const aiScene* scene) {
    const InLibrary in;
    __real_aiReleaseImport(scene);
}
}
// NOLINTEND(bugprone-reserved-identifier)
