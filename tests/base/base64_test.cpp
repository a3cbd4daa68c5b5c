#include "yarte/base/base64.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

TEST(Base64, VectorsOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Base64, DecodesWhatItEncodes) {
    std::string bytes;
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(base64Decoded(base64(bytes)), bytes) << i;
        bytes += static_cast<char>(i * 37 % 256);
    }
}

TEST(Base64, PaddingMayBeMissing) {
    EXPECT_EQ(base64Decoded("Zg"), "f");
    EXPECT_EQ(base64Decoded("Zm8"), "fo");
}

TEST(Base64, WhatIsNoneIsRefused) {
    for (const char* text :
         {"Z", "Zm9vY", "Zm 9", "Zm9v\n", "Zm-_", "Z===", "====", "=Zg=", "Zg==Zg==", "Zg="})
        EXPECT_EQ(base64Decoded(text), std::nullopt) << text;
}

} // namespace
} // namespace yarte
