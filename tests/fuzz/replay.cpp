// Without libFuzzer: a target is given the files of some folders, and so many changed forms of them, the same
// ones in every run. An input that takes too long, or a crash, ends the program; which input it was stands in
// the file "replayed-input".
#include "tests/fuzz/target.h"

#include "yarte/base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using Random = std::mt19937;

constexpr unsigned secondsForOne = 10;
constexpr std::size_t longest = 16 * 1024; // larger files are left to libFuzzer

struct Replay {
    std::vector<std::string> inputs, words;
    std::chrono::duration<double> slowest{0};
    std::size_t count = 0;
};

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

/// What a quoted word of libFuzzer's dictionaries stands for: \\, \" and \xHH are one character.
std::string unquoted(const std::string& line) {
    std::string word;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        if (line[i] != '\\')
            word += line[i];
        else if (line[++i] != 'x')
            word += line[i];
        else
            word += static_cast<char>(std::stoi(line.substr(i + 1, 2), nullptr, 16)), i += 2;
    }
    return word;
}

std::vector<std::string> wordsIn(const fs::path& dictionary) {
    std::vector<std::string> words;
    std::ifstream in(dictionary);
    for (std::string line; std::getline(in, line);)
        if (line.size() > 2 && line.front() == '"') words.push_back(unquoted(line));
    return words;
}

/// Those that the extensions name, without those that are kept; all of a folder of these ("*").
std::vector<std::string> filesIn(const fs::path& folder, const std::string& extensions) {
    std::vector<fs::path> files;
    const bool isKept = extensions == "*";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        const bool isWanted =
            isKept ||
            (!extension.empty() && extensions.find(extension) != extensions.npos &&
             entry.file_size() <= longest && entry.path().string().find("/kept/") == std::string::npos);
        if (entry.is_regular_file() && isWanted) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> inputs;
    for (const fs::path& file : files) inputs.push_back(yarte::readFile(file));
    return inputs;
}

/// So that memory without bound is a find, too. Sanitizers reserve more addresses than any limit.
void limitMemory() {
#ifndef __SANITIZE_ADDRESS__
    constexpr rlimit limit{rlim_t{2} << 30, rlim_t{2} << 30};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
}

/// Of the processor, so that a busy machine is no find; at its end the signal ends the program. 0: no limit.
/// What waits for ever instead, ctest ends.
void limitTime(int seconds) {
    const itimerval timer{{}, {seconds, 0}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

void mutate(std::string& text, const Replay& replay, Random& random) {
    const std::size_t place = below(random, text.size() + 1), length = 1 + below(random, 8);
    switch (random() % 6) {
    case 0:
        if (place < text.size()) text[place] = static_cast<char>(text[place] ^ (1 << random() % 8));
        break;
    case 1:
        if (place < text.size()) text[place] = static_cast<char>(random());
        break;
    case 2: text.erase(std::min(place, text.size()), length); break;
    case 3:
        if (!replay.words.empty()) text.insert(place, replay.words[below(random, replay.words.size())] + " ");
        break;
    case 4: text.insert(place, text.substr(below(random, text.size() + 1), length * length)); break;
    default: {
        const std::string& other = replay.inputs[below(random, replay.inputs.size())];
        text = text.substr(0, place) + other.substr(below(random, other.size() + 1));
    }
    }
    if (text.size() > longest) text.resize(longest);
}

void run(Replay& replay, const std::string& input) {
    std::ofstream("replayed-input", std::ios::binary) << input;
    const auto begin = std::chrono::steady_clock::now();
    limitTime(secondsForOne);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    limitTime(0);
    replay.slowest =
        std::max<std::chrono::duration<double>>(replay.slowest, std::chrono::steady_clock::now() - begin);
    ++replay.count;
}

} // namespace

/// replay DICTIONARY COUNT EXTENSIONS FOLDER...: all files, then COUNT mutations. A folder "kept" is taken
/// whole, and as it is: its finds are slow on purpose, and so would be what comes of them.
int main(int argc, char** argv) {
    if (argc < 5) return 2;
    limitMemory();
    Replay replay;
    replay.words = wordsIn(argv[1]);
    std::size_t files = 0;
    for (int i = 4; i < argc; ++i) {
        const bool isKept = fs::path(argv[i]).parent_path().filename() == "kept";
        if (!fs::is_directory(argv[i])) continue;
        for (std::string& input : filesIn(argv[i], isKept ? "*" : argv[3])) {
            run(replay, input), ++files;
            if (!isKept) replay.inputs.push_back(std::move(input));
        }
    }
    if (replay.inputs.empty()) replay.inputs.push_back("");
    Random random(1);
    for (int i = std::atoi(argv[2]); i > 0; --i) {
        std::string input = replay.inputs[below(random, replay.inputs.size())];
        for (std::size_t changes = 1 + below(random, 5); changes > 0; --changes)
            mutate(input, replay, random);
        run(replay, input);
    }
    fs::remove("replayed-input");
    fmt::print("{} inputs ({} files), the slowest in {:.3f} s\n", replay.count, files,
               replay.slowest.count());
}
