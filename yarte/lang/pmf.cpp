#include "yarte/lang/pmf.h"

#include "yarte/base/huge_pages.h"
#include "yarte/base/text.h"
#include "yarte/lang/pmf_scanner.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace yarte {
namespace {

/// "0 0 0\n": what a vertex or a face takes at least, so that a file's size bounds the counts it can mean.
constexpr std::size_t leastBytesPerItem = 6;

class PmfParser {
public:
    PmfParser(SourceId id, std::string_view text, Diagnostics& diagnostics)
        : id_(id), scanner_(text), textSize_(text.size()), diagnostics_(diagnostics) {}

    std::optional<MeshData> parse() {
        if (!readAll() || failed_) return std::nullopt;
        for (const Problem& problem : check(mesh_)) error(problem.code, problem.message, faceSpan(problem));
        if (failed_) return std::nullopt;
        return std::move(mesh_);
    }

private:
    bool readAll() {
        std::size_t vertexCount = 0, faceCount = 0;
        return readCount("vertices", vertexCount) && readCount("faces", faceCount) &&
               endLine("the two counts") && readVectors("vertices", vertexCount, mesh_.vertices) &&
               readFaces(faceCount) && readNormals() && endText();
    }

    /// The number of `items` that follow.
    bool readCount(const char* items, std::size_t& count) {
        const std::string_view word = scanner_.nextWord();
        if (word.empty())
            return error("pmf.truncated", fmt::format("the file ends before the number of {}", items),
                         here());
        std::uint32_t value = 0;
        if (!PmfScanner::toIndex(word, value))
            return error(
                "pmf.bad-count",
                fmt::format("the number of {} must be a whole number, got {}", items, inQuotes(word)),
                spanOf(word));
        if (value > (textSize_ + 1) / leastBytesPerItem)
            return error("pmf.truncated", fmt::format("the file is too short for {} {}", value, items),
                         spanOf(word));
        count = value;
        return true;
    }

    /// `count` times three numbers, on lines as one likes.
    bool readVectors(const char* items, std::size_t count, std::vector<Vec3>& vectors) {
        reserveWhole(vectors, count);
        for (std::size_t i = 0; i < count; ++i) {
            Vec3& v = vectors.emplace_back();
            for (double* component : {&v.x, &v.y, &v.z}) {
                if (scanner_.nextNumber(*component)) continue;
                const std::string_view word = scanner_.nextWord();
                if (word.empty())
                    return error("pmf.truncated",
                                 fmt::format("the file ends after {} of {} {}", i, count, items), here());
                error("pmf.bad-number",
                      fmt::format("a coordinate must be a number below 1.8e308, got {}", inQuotes(word)),
                      spanOf(word));
                if (diagnostics_.full()) return false;
            }
        }
        return count == 0 || endLine(fmt::format("the last of {} {}", count, items));
    }

    /// The rest of the line must be empty: what is left over shows that something before is missing.
    bool endLine(std::string_view items) {
        const std::string_view word = scanner_.nextWordOnLine();
        if (word.empty()) return true;
        return error("pmf.count-mismatch",
                     fmt::format("the line must end after {}, got {}", items, inQuotes(word)), spanOf(word));
    }

    bool readFaces(std::size_t count) {
        reserveWhole(mesh_.faceStarts, count + 1);
        reserveWhole(mesh_.corners, 3 * count);
        faces_ = scanner_;
        for (std::size_t f = 0; f < count && !diagnostics_.full(); ++f) {
            if (!beginLine("faces", f, count)) return false;
            readIndices(mesh_.vertices.size(), mesh_.corners);
            mesh_.faceStarts.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        }
        return true;
    }

    /// Goes to the next line that has something; it must not begin with a word.
    bool beginLine(const char* items, std::size_t number, std::size_t count) {
        scanner_.skipSpace();
        if (scanner_.atEnd())
            return error("pmf.truncated",
                         fmt::format("the file ends after {} of {} {}", number, count, items), here());
        if (!scanner_.atLetter()) return true;
        const std::string_view word = scanner_.nextWord();
        return error(
            "pmf.count-mismatch",
            fmt::format("there must be {} {}, got {} before {}", count, items, number, inQuotes(word)),
            spanOf(word));
    }

    /// All that the line has, each below `limit`.
    void readIndices(std::size_t limit, std::vector<std::uint32_t>& indices) {
        while (scanner_.moreOnLine()) {
            std::uint32_t& index = indices.emplace_back();
            if (scanner_.nextIndex(limit, index)) continue;
            const std::string_view word = scanner_.nextWord();
            error("pmf.bad-index",
                  fmt::format("an index must be a whole number below {}, got {}", limit, inQuotes(word)),
                  spanOf(word));
            if (diagnostics_.full()) return;
        }
    }

    /// The optional part: `normals N`, N vectors, `face_normals`, a line of indices for each face.
    bool readNormals() {
        if (!scanner_.skipWord("normals")) return true;
        std::size_t count = 0;
        if (!readCount("normals", count) || !endLine("the number of normals") ||
            !readVectors("normals", count, mesh_.normals))
            return false;
        const std::string_view word = scanner_.nextWord();
        if (word.empty()) return error("pmf.truncated", "the file ends before 'face_normals'", here());
        if (word != "face_normals")
            return error("pmf.expected-face-normals",
                         fmt::format("'face_normals' must follow the normals, got {}", inQuotes(word)),
                         spanOf(word));
        if (!endLine("'face_normals'")) return false;
        reserveWhole(mesh_.cornerNormals, mesh_.corners.size());
        for (std::size_t f = 0; f < mesh_.faceCount() && !diagnostics_.full(); ++f) {
            if (!beginLine("face_normals", f, mesh_.faceCount())) return false;
            const std::size_t offset = scanner_.offset();
            readIndices(mesh_.normals.size(), mesh_.cornerNormals);
            if (mesh_.cornerNormals.size() != mesh_.faceStarts[f + 1])
                return error("pmf.count-mismatch",
                             fmt::format("a face must have as many normals as vertices, {}, got {}",
                                         mesh_.face(f).size(),
                                         mesh_.cornerNormals.size() - mesh_.faceStarts[f]),
                             {id_, offset, scanner_.offset()});
        }
        return true;
    }

    bool endText() {
        const std::string_view word = scanner_.nextWord();
        if (word.empty()) return true;
        return error("pmf.trailing-text",
                     fmt::format("the file must end after its last face, got {}", inQuotes(word)),
                     spanOf(word));
    }

    /// Always false.
    bool error(std::string_view code, std::string message, Span span) {
        diagnostics_.error(code, std::move(message), span);
        failed_ = true;
        return false;
    }

    /// Behind the last word, where the text ends too early.
    Span here() const {
        const std::size_t end = scanner_.endOfText();
        return {id_, end, end};
    }
    Span spanOf(std::string_view word) const {
        return {id_, scanner_.offset() - word.size(), scanner_.offset()};
    }
    Span faceSpan(const Problem& problem) const {
        if (problem.argument < 0) return {id_, 0, 0};
        const std::size_t begin = offsetOfFace(problem.argument);
        return {id_, begin, scanner_.endOfLine(begin)};
    }
    /// Of its line: looked for when there is something to say about it, not kept of millions of them.
    std::size_t offsetOfFace(int face) const {
        PmfScanner scanner = faces_;
        scanner.skipSpace();
        for (int before = 0; before < face; ++before) {
            while (scanner.moreOnLine()) scanner.nextWord();
            scanner.skipSpace();
        }
        return scanner.offset();
    }

    SourceId id_;
    PmfScanner scanner_;
    PmfScanner faces_ = scanner_; ///< before the first face
    std::size_t textSize_;
    Diagnostics& diagnostics_;
    bool failed_ = false;
    MeshData mesh_;
};

} // namespace

std::optional<MeshData> parsePmf(SourceId id, const Sources& sources, Diagnostics& diagnostics) {
    const Source& source = sources[id];
    const std::string_view text = source.text();
    if (text.find('\0') != text.npos) {
        diagnostics.error("lang.binary-file", "the file is binary, not the text of a mesh").file =
            source.name();
        return std::nullopt;
    }
    if (text.size() > std::numeric_limits<std::uint32_t>::max()) { // so that every count fits its 32 bits
        diagnostics.error("pmf.too-large", "a mesh file must be smaller than 4 GiB").file = source.name();
        return std::nullopt;
    }
    return PmfParser(id, text, diagnostics).parse();
}

std::optional<MeshData> readPmf(const std::filesystem::path& file, const ReadableFolders&, Sources& sources,
                                Diagnostics& diagnostics) {
    try {
        const SourceId id = sources.add(file.string(), readFile(file));
        std::optional<MeshData> mesh = parsePmf(id, sources, diagnostics);
        if (mesh) sources.release(id);
        return mesh;
    } catch (const FileError& e) {
        diagnostics.error("pmf.unreadable", fmt::format("cannot read the file: {}", e.reason())).file =
            file.string();
        return std::nullopt;
    }
}

} // namespace yarte
