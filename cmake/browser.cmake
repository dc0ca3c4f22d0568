# The libraries of the browser edition, from sources: those of build/web-tools (scripts/web/install-tools) and headers of the
# system. It defines the same targets as find_package and pkg_check_modules do elsewhere.
set(WEB_TOOLS ${CMAKE_SOURCE_DIR}/build/web-tools)

function(add_headers name)
    add_library(${name} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${name} SYSTEM INTERFACE ${WEB_TOOLS}/include ${ARGN})
endfunction()
add_headers(glm::glm)
add_headers(nlohmann_json::nlohmann_json)
add_headers(Eigen3::Eigen)
add_headers(fmt::fmt-header-only)
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY=1)
set(FMT_LIBRARY fmt::fmt-header-only)
add_headers(Threads::Threads)   # there is one thread
add_headers(PkgConfig::CLP)     # page/substitutes/inspect/circle_bounds.cpp does without

# A library whose warnings are not ours.
function(add_foreign name folder)
    list(TRANSFORM ARGN PREPEND ${WEB_TOOLS}/${folder}/)
    add_library(${name} STATIC ${ARGN})
    target_compile_options(${name} PRIVATE -w)
    set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()

add_foreign(imgui imgui imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp misc/cpp/imgui_stdlib.cpp)
target_include_directories(imgui SYSTEM PUBLIC ${WEB_TOOLS}/imgui ${WEB_TOOLS}/imgui/misc/cpp ${WEB_TOOLS}/imgui/backends)
add_library(PkgConfig::IMGUI ALIAS imgui)

add_foreign(meshoptimizer meshoptimizer/src simplifier.cpp vfetchoptimizer.cpp indexgenerator.cpp allocator.cpp)
target_include_directories(meshoptimizer SYSTEM PUBLIC ${WEB_TOOLS}/meshoptimizer/src)
add_library(meshoptimizer::meshoptimizer ALIAS meshoptimizer)

add_foreign(zlib zlib adler32.c crc32.c deflate.c inflate.c inftrees.c inffast.c trees.c zutil.c compress.c uncompr.c)
target_include_directories(zlib SYSTEM PUBLIC ${WEB_TOOLS}/zlib)

add_foreign(imgui_opengl3 imgui backends/imgui_impl_opengl3.cpp)
target_compile_definitions(imgui_opengl3 PRIVATE IMGUI_IMPL_OPENGL_ES3)
target_link_libraries(imgui_opengl3 PUBLIC imgui)

# Assimp with the readers of OBJ, PLY and STL and the two steps that core/scene uses.
set(ASSIMP ${WEB_TOOLS}/assimp)
file(WRITE ${CMAKE_BINARY_DIR}/assimp/revision.h
    "#define GitVersion 0\n#define GitBranch \"\"\n#define VER_MAJOR 5\n#define VER_MINOR 2\n#define VER_PATCH 5\n#define VER_BUILD 0\n")
file(READ ${ASSIMP}/include/assimp/config.h.in text)
string(REPLACE "#cmakedefine" "// " text "${text}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/assimp/assimp/config.h CONTENT "${text}" @ONLY)
file(STRINGS ${ASSIMP}/code/Common/PostStepRegistry.cpp steps REGEX "ASSIMP_BUILD_NO_[A-Z_]+_PROCESS")
file(STRINGS ${ASSIMP}/code/Common/ImporterRegistry.cpp formats REGEX "ASSIMP_BUILD_NO_[A-Z0-9_]+_IMPORTER")
string(REGEX MATCHALL "ASSIMP_BUILD_NO_[A-Z0-9_]+_(PROCESS|IMPORTER)" left_out "${steps} ${formats}")
list(REMOVE_DUPLICATES left_out)
list(FILTER left_out EXCLUDE REGEX "_(OBJ|PLY|STL)_IMPORTER|_(TRIANGULATE|VALIDATEDS|ARMATUREPOPULATE|DEBONE)_PROCESS")
set(common Assimp Base64 BaseImporter BaseProcess CreateAnimMesh DefaultIOStream DefaultIOSystem DefaultLogger Exceptional IOSystem
    Importer ImporterRegistry PostStepRegistry RemoveComments SGSpatialSort SceneCombiner ScenePreprocessor SkeletonMeshBuilder
    SpatialSort StandardShapes Subdivision TargetAnimation Version VertexTriangleAdjacency material scene simd)
list(TRANSFORM common REPLACE "(.+)" "code/Common/\\1.cpp")
set(steps ValidateDataStructure TriangulateProcess ProcessHelper ArmaturePopulate DeboneProcess)
list(TRANSFORM steps REPLACE "(.+)" "code/PostProcessing/\\1.cpp")
set(readers Obj/ObjFileImporter Obj/ObjFileMtlImporter Obj/ObjFileParser Ply/PlyLoader Ply/PlyParser STL/STLLoader)
list(TRANSFORM readers REPLACE "(.+)" "code/AssetLib/\\1.cpp")
add_foreign(assimp assimp ${common} ${steps} ${readers} code/CApi/CInterfaceIOWrapper.cpp code/Material/MaterialSystem.cpp)
target_compile_definitions(assimp PRIVATE ${left_out} ASSIMP_BUILD_NO_EXPORT ASSIMP_BUILD_NO_GLTF_IMPORTER
    ASSIMP_BUILD_NO_GLTF1_IMPORTER ASSIMP_BUILD_NO_GLTF2_IMPORTER)
target_include_directories(assimp
    PRIVATE ${ASSIMP} ${ASSIMP}/code ${ASSIMP}/contrib ${ASSIMP}/contrib/pugixml/src
    PUBLIC ${CMAKE_BINARY_DIR}/assimp ${ASSIMP}/include)
add_library(assimp::assimp ALIAS assimp)

# What a browser lacks is done by another file of the same name, in page/substitutes.
function(substitute_sources list)
    set(sources ${${list}})
    foreach(source IN LISTS sources)
        file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR}/core ${source})
        if(EXISTS ${CMAKE_SOURCE_DIR}/page/substitutes/${name})
            list(REMOVE_ITEM ${list} ${source})
            list(APPEND ${list} ${CMAKE_SOURCE_DIR}/page/substitutes/${name})
        endif()
    endforeach()
    set(${list} ${${list}} PARENT_SCOPE)
endfunction()
