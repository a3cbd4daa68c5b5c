// The parts that document.cpp puts together. Private to the document_*.cpp files.
#pragma once

#include "convert/gltf/document.h"

namespace yarte::convert::gltf {

void readBuffers(const Object& root, Document&, Errors&);
void readMeshes(const Object& root, Document&);
void readSkins(const Object& root, Document&);
void readNodes(const Object& root, Document&);
void readScene(const Object& root, Document&);

} // namespace yarte::convert::gltf
