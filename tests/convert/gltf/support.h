// glTF in memory, for tests: a scene out, a scene in.
#pragma once

#include "tests/convert/support.h"

#include "convert/gltf/read.h"
#include "convert/gltf/write.h"
#include "yarte/lang/scene_printer.h"

namespace yarte::convert::test {

/// The one file that a scene becomes: a .glb, or a .gltf with its data within.
inline std::string written(const Scene& scene, bool binary) {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    Conversion c{{}, {}, {}, sources, diagnostics, ledger};
    const auto files = binary ? gltf::writeGlb(scene, c) : gltf::writeGltf(scene, c);
    return files.size() == 1 ? files[0].bytes : std::string();
}

/// What reading a text as glTF gives.
struct ReadGltf {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    std::optional<Scene> scene;

    explicit ReadGltf(std::string bytes) {
        Conversion c{{sources.add("t.gltf", std::move(bytes)), {}, {}}, {}, {}, sources, diagnostics, ledger};
        scene = gltf::readScene(c);
    }
    std::string problems() const { return format(diagnostics, sources, DiagnosticStyle::plain); }
    /// "where|property|action" of the rows that hold `what`.
    bool tells(const std::string& where, const std::string& property, Action action) const {
        for (const LedgerRow& row : ledger.rows())
            if (row.where == where && row.property.find(property) != std::string::npos && row.action == action)
                return true;
        return false;
    }
};

} // namespace yarte::convert::test
