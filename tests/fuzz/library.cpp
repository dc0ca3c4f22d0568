// library.cpp -- wraps functions of Assimp. The linker redirects their calls to this file (--wrap in
// CMakeLists.txt).
#include "tests/fuzz/library.hpp"

#include <assimp/scene.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <assimp/Importer.hpp>

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
const aiScene* __real__ZN6Assimp8Importer8ReadFileEPKcj(Assimp::Importer*, const char*, unsigned);
const aiScene* __wrap__ZN6Assimp8Importer8ReadFileEPKcj(Assimp::Importer* self, const char* file,
                                                        unsigned flags) {
    const InLibrary in;
    return __real__ZN6Assimp8Importer8ReadFileEPKcj(self, file, flags);
}

const aiScene* __real__ZN6Assimp8Importer19ApplyPostProcessingEj(Assimp::Importer*, unsigned);
const aiScene* __wrap__ZN6Assimp8Importer19ApplyPostProcessingEj(Assimp::Importer* self, unsigned flags) {
    const InLibrary in;
    return __real__ZN6Assimp8Importer19ApplyPostProcessingEj(self, flags);
}

void __real__ZN6Assimp8ImporterD1Ev(Assimp::Importer*);
void __wrap__ZN6Assimp8ImporterD1Ev(Assimp::Importer* self) {
    const InLibrary in;
    __real__ZN6Assimp8ImporterD1Ev(self);
}
}
// NOLINTEND(bugprone-reserved-identifier)
