// Text of foreign origin as it is shown.
#include "kernel/base/error.h"

#include <gtest/gtest.h>

namespace axiscert {
namespace {

TEST(Text, WhatATerminalOrABrowserWouldObeyIsShownByItsNumber) {
  EXPECT_EQ(printable_line("a\nb\tc\rd"), "a\\nb\\tc\\rd");
  EXPECT_EQ(printable_line(std::string_view("\x1b[31m\0\x7f", 7)), "\\u001b[31m\\u0000\\u007f");
  EXPECT_EQ(printable_line("\xc2\x9b"), "\\u009b") << "CSI, in one byte of Latin-1";
  EXPECT_EQ(printable_line("a\u202eb"), "a\\u202eb");
  for (const char* turns : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u2066", "\u2067",
                            "\u2068", "\u2069", "\u2028", "\u2029", "\ufeff"}) {
    EXPECT_EQ(printable_line(turns).substr(0, 2), "\\u") << printable_line(turns);
  }
}

TEST(Text, AByteThatIsNoCharacterIsShownToo) {
  EXPECT_EQ(printable_line("k\xff.so"), "k\\xff.so");
  EXPECT_EQ(printable_line("\xe2\x80"), "\\xe2\\x80") << "cut off";
  EXPECT_EQ(printable_line("\xc0\x8a"), "\\xc0\\x8a") << "an overlong line feed";
}

TEST(Text, OtherTextIsUnchangedAndSoIsWhatWasShown) {
  for (const char* plain : {"", "C:\\new", "Kugel–Dreieck \u4e09\u89d2 \U0001f53a", "\u200b"})
    EXPECT_EQ(printable_line(plain), plain);
  const std::string once = printable_line("\x1b\n\u202e\xff");
  EXPECT_EQ(printable_line(once), once);
  EXPECT_TRUE(is_utf8(once));
}

}  // namespace
}  // namespace axiscert
