// What became of everything in a glTF file, for the ledger.
#pragma once

#include "convert/gltf/json.h"
#include "convert/ledger.h"

namespace yarte::convert::gltf {

/// A row for each property that occurs in `root`, an array's elements taken together ("/materials/*"): what
/// was never looked at is dropped, by the fates of all that the tree holds.
void addRows(const Json& root, Ledger&);

} // namespace yarte::convert::gltf
