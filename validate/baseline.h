// Baseline: stored pictures of YARTE's that later ones are compared with. A folder with baseline.json, which
// says which scene each is of, and an .exr a scene: linear, 32 bits, so that not a bit is lost. Beside it,
// .bodies.exr says which body is seen where: a later scene does not know the bodies that it has lost.
#pragma once

#include "validate/image_file.h"
#include "validate/picture.h"
#include "validate/report.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// The references of `folder`; a folder that does not exist has none.
class Baseline {
public:
    /// Throws FileError, also for a baseline.json that is none.
    explicit Baseline(std::filesystem::path folder);

    const std::filesystem::path& folder() const { return folder_; }

    bool has(const std::string& name) const;
    /// Throws CaseError if there is none or it cannot be read.
    Picture read(const std::string& name) const;
    /// Which body of the reference's scene is seen where; nothing if that was not kept or cannot be read.
    std::optional<Layers> readBodies(const std::string& name) const;
    /// Adds or replaces one. Cases of different names may be stored by different threads. Throws FileError.
    void store(const std::string& name, const Picture&) const;
    /// The same of what readBodies gives; nothing: it is not known.
    void storeBodies(const std::string& name, const std::optional<Layers>&) const;

    struct Scene {
        std::string name;
        std::filesystem::path file;
    };
    /// Writes baseline.json with these scenes too; what belongs to scenes that no longer exist is removed,
    /// and their names are returned.
    std::vector<std::string> update(const std::vector<Scene>& stored);

private:
    std::filesystem::path pictureFile(const std::string& name) const { return folder_ / (name + ".exr"); }
    std::filesystem::path bodiesFile(const std::string& name) const {
        return folder_ / (name + ".bodies.exr");
    }

    std::filesystem::path folder_;
    std::vector<Scene> scenes_; ///< by name; paths relative to the folder
};

/// "baseline: 1 new (a), 1 changed (b: max 0.25), 1 removed (c), 5 unchanged".
std::string baselineLine(const Report&, const std::vector<std::string>& removed);

} // namespace yarte::validate
