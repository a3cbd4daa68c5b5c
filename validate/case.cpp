#include "validate/case.h"

#include "validate/case_names.h"
#include "validate/display.h"
#include "validate/text.h"
#include "yarte/base/file.h"

#include <fmt/format.h>
#include <optional>

namespace yarte::validate {

namespace {

/// The case's folder in the report.
class CaseFolder {
public:
    /// Nothing of an earlier run may seem to belong to this one; what is not ours stays.
    CaseFolder(CaseReport& report, const std::filesystem::path& output)
        : report_(report), path_(output / folderOf(report)) {
        std::filesystem::create_directories(path_);
        for (const char* file : {yartePictureFile, povrayPictureFile, povraySceneFile, "yarte.png",
                                 "povray.png", "a.png", "b.png", "difference.png"})
            std::filesystem::remove(path_ / file);
    }

    void keep(const Workshop& workshop, const std::string& file) const {
        if (std::filesystem::exists(workshop.file(file)))
            writeFile(path_ / file, readFile(workshop.file(file)));
    }
    void addPicture(const std::string& label, const std::string& file, const DisplayPicture& picture) {
        writeFile(path_ / file, encodePng(picture));
        report_.pictures.push_back({label, file});
    }

private:
    CaseReport& report_;
    std::filesystem::path path_;
};

/// A picture with its name in messages and in the report, and its file there.
struct Side {
    std::string name, label, file;
    std::optional<Picture> picture;
};

/// Both pictures if they are there, and their difference.
void addPictures(CaseFolder& folder, const Side& a, const Side& b, const Tolerance& tolerance) {
    for (const Side* side : {&a, &b})
        if (side->picture) folder.addPicture(side->label, side->file, displayPicture(side->picture->view()));
    if (a.picture && b.picture && a.picture->width == b.picture->width &&
        a.picture->height == b.picture->height)
        folder.addPicture("difference", "difference.png",
                          differencePicture(a.picture->view(), b.picture->view(), tolerance.threshold));
}

void compareSides(CaseReport& report, const Side& a, const Side& b, const Tolerance& tolerance) {
    decide(report, compare({a.name, *a.picture}, {b.name, *b.picture}, tolerance), tolerance);
}

void setSize(CaseReport& report, const Picture& picture) {
    report.width = picture.width;
    report.height = picture.height;
}

} // namespace

CaseReport validateScene(const std::string& name, const std::filesystem::path& scene,
                         const CaseSettings& settings, const StopSignal& stop) {
    CaseReport report;
    report.name = name;
    report.source = cleanText(scene.string());
    CaseFolder folder(report, settings.output);
    Workshop workshop(settings.temporaryFolder, settings.timeLimit, stop);
    Side yarte{"yarte's picture", "YARTE", "yarte.png", {}};
    Side povray{"POV-Ray's picture", "POV-Ray", "povray.png", {}};
    const auto path = std::filesystem::absolute(scene);
    try {
        yarte.picture = renderWithYarte(workshop, settings.render, path, report.yarte);
        setSize(report, *yarte.picture);
        checkFinite({yarte.name, *yarte.picture});
        report.exposure = exposureFor(maxValue(yarte.picture->view()));
        yarte.picture = scaled(std::move(*yarte.picture), report.exposure);
        povray.picture = renderWithPovray(workshop, settings.render, path, report.exposure, report.width,
                                          report.height, report.povray);
        compareSides(report, yarte, povray, settings.tolerance);
    } catch (const CaseError& error) {
        report.message = error.what();
    }
    report.commands = workshop.commands();
    for (const char* file : {yartePictureFile, povrayPictureFile, povraySceneFile})
        folder.keep(workshop, file);
    addPictures(folder, yarte, povray, settings.tolerance);
    return report;
}

CaseReport validateImages(const std::filesystem::path& a, const std::filesystem::path& b, Encoding integers,
                          const CaseSettings& settings) {
    CaseReport report;
    report.name = folderName(a.stem().string() + "-" + b.stem().string());
    report.source = cleanText(fmt::format("{} and {}", a.string(), b.string()));
    CaseFolder folder(report, settings.output);
    Side first{cleanText(a.string()), cleanText(a.filename().string()), "a.png", {}};
    Side second{cleanText(b.string()), cleanText(b.filename().string()), "b.png", {}};
    try {
        first.picture = readPicture(a, integers);
        second.picture = readPicture(b, integers);
        setSize(report, *first.picture);
        compareSides(report, first, second, settings.tolerance);
    } catch (const CaseError& error) {
        report.message = error.what();
    } catch (const ImageError& error) {
        report.message = cleanText(error.what());
    }
    addPictures(folder, first, second, settings.tolerance);
    return report;
}

} // namespace yarte::validate
