// score_others POVRAY ATTACKS RAYS...: YARTE, POV-Ray and Embree on the same hard rays: ATTACKS random ones
// for each shape, and the labelled ones of the files RAYS. Prints tables in Markdown.
#include "tests/hard/attack.h"
#include "tests/hard/others/embree_answers.h"
#include "tests/hard/others/povray_answers.h"
#include "tests/hard/suite.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

using namespace yarte;
using namespace yarte::hard;

namespace {

/// What one program made of many cases.
struct Tally {
    int counted = 0; ///< decidable, and asked
    int wrong = 0, inexact = 0;
    double worstT = 0, worstNormal = 0; ///< of right hits, in ulps over max(1, condition)

    void add(bool isRight, double tError, double normalError) {
        ++counted;
        wrong += !isRight;
        inexact += isRight && !(tError <= maxError && normalError <= maxError);
        worstT = std::max(worstT, tError), worstNormal = std::max(worstNormal, normalError);
    }
    std::string decisions() const { return counted == 0 ? "" : fmt::format("{} of {}", wrong, counted); }
    std::string numbers() const {
        return counted == 0 ? "" : fmt::format("{}; {:.2g}, {:.2g}", inexact, worstT, worstNormal);
    }
};

/// `epsilon`: the distance of neighbouring numbers at 1.
void addOther(Tally& tally, const Truth& truth, const OtherAnswer& answer, double epsilon) {
    const auto& [wasAsked, hit] = answer;
    if (!wasAsked) return;
    const bool isRight = hit.has_value() == truth.hit.has_value() && (!hit || hit->body == truth.hit->body);
    if (!isRight || !hit) return tally.add(isRight, 0, 0);
    const double t = static_cast<double>(truth.hit->t);
    const double ulp = 2 * halfUlp(t) * (epsilon / 0x1p-52);
    const auto distance = [&](double sign) {
        const Vec<Real>& n = truth.hit->normal;
        return length({static_cast<double>(n.x - Real(sign * hit->normal.x)),
                       static_cast<double>(n.y - Real(sign * hit->normal.y)),
                       static_cast<double>(n.z - Real(sign * hit->normal.z))});
    };
    tally.add(true,
              static_cast<double>(abs(truth.hit->t - hit->t)) / ulp / std::max(1.0, truth.hit->tCondition),
              std::min(distance(1), distance(-1)) / epsilon / std::max(1.0, truth.hit->normalCondition));
}

/// As Truth::isDecidable, with half an ulp of a float for each input. Without ties, of which Embree promises
/// nothing.
bool isDecidableInFloat(const Truth& truth) {
    return truth.isDecidable && abs(truth.value) > Real(truth.range) * Real(0x1p29);
}

constexpr std::array programs{"YARTE", "POV-Ray", "Embree, fast", "Embree, robust"};
using Tallies = std::array<Tally, programs.size()>;

Tallies tally(const std::vector<Case>& cases, const char* povray) {
    Tallies result;
    auto& [yarte, pov, fast, robust] = result;
    const std::vector<OtherAnswer> povraySays = askPovray(povray, cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Truth truth = truthOf(cases[i].scene, cases[i].ray);
        if (truth.isDecidable) {
            const Answer a = answer(cases[i], truth);
            yarte.add(a.isRight, a.tError, a.normalError);
            addOther(pov, truth, povraySays[i], 0x1p-52);
        }
        const Case inFloat = roundedToFloat(cases[i]);
        const OtherAnswer inFastMode = askEmbree(inFloat, EmbreeMode::fast);
        if (!inFastMode.wasAsked) continue;
        const Truth floatTruth = truthOf(inFloat.scene, inFloat.ray);
        if (!isDecidableInFloat(floatTruth)) continue;
        addOther(fast, floatTruth, inFastMode, 0x1p-23);
        addOther(robust, floatTruth, askEmbree(inFloat, EmbreeMode::robust), 0x1p-23);
    }
    return result;
}

struct Row {
    std::string rays;
    Tallies tallies;
};

std::vector<Row> attacked(int attacks, const char* povray) {
    std::vector<Row> rows;
    for (const std::string_view shape : attackedShapes()) {
        std::vector<Case> cases;
        for (int i = 0; i < attacks; ++i) {
            test::Random random(static_cast<unsigned>(i));
            cases.push_back(attack(shape, random));
        }
        rows.push_back({fmt::format("attacks: {}", shape), tally(cases, povray)});
    }
    return rows;
}

Row labelledIn(const std::filesystem::path& file, const char* povray) {
    std::vector<Case> cases;
    for (const LabelledRay& ray : readRays(file))
        if (!ray.isTie()) cases.push_back(ray.problem);
    return {fmt::format("labelled: {}", file.stem().string()), tally(cases, povray)};
}

void print(const std::vector<Row>& rows, std::string (Tally::*cell)() const) {
    fmt::print("| rays | {} |\n|---|{}\n", fmt::join(programs, " | "), "---:|---:|---:|---:|");
    for (const Row& row : rows) {
        fmt::print("| {} |", row.rays);
        for (const Tally& one : row.tallies) fmt::print(" {} |", (one.*cell)());
        fmt::print("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: score_others POVRAY ATTACKS RAYS...\n", stderr);
        return 2;
    }
    try {
        std::vector<Row> rows = attacked(std::atoi(argv[2]), argv[1]);
        for (int file = 3; file < argc; ++file) rows.push_back(labelledIn(argv[file], argv[1]));
        fmt::print("## Wrong decisions, of decidable cases\n\n");
        print(rows, &Tally::decisions);
        fmt::print("\n## Right, but inexact; the worst t and normal\n\n");
        print(rows, &Tally::numbers);
    } catch (const std::exception& e) {
        fmt::print(stderr, "score_others: {}\n", e.what());
        return 3;
    }
}
