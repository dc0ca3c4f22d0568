// folder_files.hpp -- the files that Assimp may open while it reads a mesh.
#pragma once
#include <assimp/DefaultIOSystem.h>
#include <filesystem>
#include <optional>
#include <string>

namespace momentscope {

/// Opens files for reading, the mesh and what lies in its folder or below. Names that a mesh file gives may
/// be percent-encoded or file:// URIs. Whatever leads out of the folder, be it by "..", an absolute path or a
/// symbolic link, stays closed and is remembered.
class FolderFiles : public Assimp::DefaultIOSystem {
public:
    /// `text` is read in the place of the file itself, if given. `uris`: are names percent-encoded, as in
    /// glTF? Otherwise they are taken as they are first.
    FolderFiles(std::filesystem::path mesh, std::optional<std::string> text, bool uris);

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode = "rb") override;

    /// The first file that stayed closed, as the mesh file names it.
    const std::optional<std::string>& outside() const { return outside_; }

private:
    std::optional<std::string> found(const std::string& file) const;

    std::filesystem::path mesh_;
    std::filesystem::path folder_;  // without links and dots
    std::optional<std::string> text_;
    bool uris_;
    mutable std::optional<std::string> outside_;
};

}  // namespace momentscope
