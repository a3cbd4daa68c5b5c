// Running POV-Ray in a test.
#pragma once

#include "yarte/base/file.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace yarte::test {

inline bool hasPovray() { return std::system("command -v povray > /dev/null") == 0; }

struct PovrayRun {
    int status = 0;   ///< as of waitpid
    std::string said; ///< on the console
};

/// In `folder`, where its words also go to console.txt. On a busy machine POV-Ray may give up before it
/// begins, as its threads are late; it is then asked again.
inline PovrayRun runPovray(const std::filesystem::path& folder, const std::string& arguments) {
    const std::string command = "cd '" + folder.string() + "' && povray " + arguments + " > console.txt 2>&1";
    for (int attemptsLeft = 2;; --attemptsLeft) {
        const int status = std::system(command.c_str());
        std::string said = readFile(folder / "console.txt");
        if (attemptsLeft == 0 || said.find("worker thread startup") == said.npos)
            return {status, std::move(said)};
    }
}

} // namespace yarte::test
