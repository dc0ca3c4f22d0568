// folder_files.hpp -- limits the files that Assimp may open while it reads a mesh.
#pragma once
#include <assimp/cfileio.h>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace momentscope {

/// Opens files for reading: the mesh, and files in its folder or below. Names in a mesh file may be
/// percent-encoded or file:// URIs. Names that lead out of the folder, by "..", an absolute path or a
/// symbolic link, are not opened, but remembered.
class FolderFiles {
public:
    /// text: read instead of the mesh file itself, if given. uris: true if names are percent-encoded, as in
    /// glTF. Otherwise names are first tried as they are.
    FolderFiles(std::filesystem::path mesh, std::optional<std::string> text, bool uris);

    /// The file of this name; null if there is none or it must not be opened.
    std::unique_ptr<std::istream> open(const std::string& name);

    /// These files for the C interface of Assimp. Valid as long as this object, which must not move.
    aiFileIO for_assimp();

    /// The first file that was not opened, as the mesh file names it.
    const std::optional<std::string>& outside() const { return outside_; }

private:
    std::optional<std::string> found(const std::string& file);

    std::filesystem::path mesh_;
    std::filesystem::path folder_;  // with links and dots resolved
    std::optional<std::string> text_;
    bool uris_;
    std::optional<std::string> outside_;
};

}  // namespace momentscope
