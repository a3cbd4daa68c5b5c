#include "validate/case_folder.h"

#include "validate/image_file.h"
#include "validate/metrics.h"
#include "validate/renderers.h"
#include "yarte/base/file.h"

namespace yarte::validate {

namespace {

/// A picture with nan or infinity has no samples to show.
bool canBeShown(const Side& side) { return side.picture && nonFinitePixels(side.picture->view()).count == 0; }

} // namespace

CaseFolder::CaseFolder(CaseReport& report, const std::filesystem::path& output)
    : report_(report), path_(output / folderOf(report)) {
    std::filesystem::create_directories(path_);
    for (const char* file : {yartePictureFile, povrayPictureFile, povraySceneFile, importedSceneFile,
                             "yarte.png", "povray.png", "baseline.png", "a.png", "b.png", "difference.png"})
        std::filesystem::remove(path_ / file);
}

void CaseFolder::keep(const Workshop& workshop, const std::string& file) const {
    if (std::filesystem::exists(workshop.file(file))) writeFile(path_ / file, readFile(workshop.file(file)));
}

void CaseFolder::addPictures(const Side& a, const Side& b, const std::optional<FlipMap>& flip,
                             double threshold, std::size_t pageLimit) {
    for (const Side* side : {&a, &b})
        if (side->picture) addPicture(side->label, side->file, displayPicture(side->picture->view()));
    if (a.picture && b.picture && haveOneSize(*a.picture, *b.picture))
        addPicture("difference", "difference.png",
                   differencePicture(a.picture->view(), b.picture->view(), threshold));
    if (flip) {
        report_.page = pagePixels(a.picture->view(), b.picture->view(), *flip, pageLimit);
        report_.sides[0] = a.label;
        report_.sides[1] = b.label;
    } else if (const Side* side = canBeShown(a) ? &a : canBeShown(b) ? &b : nullptr) {
        report_.page = pagePixels(side->picture->view(), pageLimit);
        report_.sides[side == &a ? 0 : 1] = side->label;
    }
}

void CaseFolder::addPicture(const std::string& label, const std::string& file,
                            const DisplayPicture& picture) {
    writeFile(path_ / file, encodePng(picture));
    report_.pictures.push_back({label, file});
}

} // namespace yarte::validate
