// folder_files.hpp -- limits the files that Assimp may open while it reads a mesh.
#pragma once
#include <assimp/DefaultIOSystem.h>
#include <filesystem>
#include <optional>
#include <string>

namespace momentscope {

/// Opens files for reading: the mesh, and files in its folder or below. Names in a mesh file may be
/// percent-encoded or file:// URIs. Names that lead out of the folder, by "..", an absolute path or a
/// symbolic link, are not opened, but remembered.
class FolderFiles : public Assimp::DefaultIOSystem {
public:
    /// text: read instead of the mesh file itself, if given. uris: true if names are percent-encoded, as in
    /// glTF. Otherwise names are first tried as they are.
    FolderFiles(std::filesystem::path mesh, std::optional<std::string> text, bool uris);

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode = "rb") override;

    /// The first file that was not opened, as the mesh file names it.
    const std::optional<std::string>& outside() const { return outside_; }

private:
    std::optional<std::string> found(const std::string& file) const;

    std::filesystem::path mesh_;
    std::filesystem::path folder_;  // with links and dots resolved
    std::optional<std::string> text_;
    bool uris_;
    mutable std::optional<std::string> outside_;
};

}  // namespace momentscope
