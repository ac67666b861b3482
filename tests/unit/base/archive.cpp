// Zip archives: what is written reads back; what is broken, hostile or unusual is refused with its code.
#include <gonio/base/inflate.hpp>

#include "../archives.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gonio {

namespace {

using namespace std::string_literals;
using test::code_of;
using test::put16;
using test::put32;

// By zlib, of squares() and of "candela candela candela lumen".
const std::string dynamic_block(
    "\x1d\x93\xc7\x15\x84\x30\x0c\x44\x5b\x51\x09\x28\x58\xa1\xff\xc6\xf6\xcf\x1e\x78\x06\x94\x26\xc8\x9f\xb9\x95\x9d"
    "\x79\x5b\x3c\xcb\xb6\x3a\xeb\xb2\x75\xf3\xef\x33\x0f\xce\x2a\xa2\x64\x1c\x29\xe4\xc4\xe3\xdc\xb3\x8c\x22\x9f\x6a"
    "\xf2\xaa\x38\xb7\xec\xc5\xd9\x9b\xb6\x26\xaf\x39\x87\xef\xe1\xff\x12\x3f\xf2\x8e\xfc\x18\xbb\x30\x7f\x47\xb7\xb5"
    "\x38\x3a\x4d\xd0\x61\xa8\x2e\xeb\x2f\xad\xa9\x98\x1e\xdb\x17\x76\x49\x1c\x10\x11\x16\x0e\x40\x67\xd8\x47\xea\xc7"
    "\x10\xce\xe1\x7b\xf9\x7f\xc4\x13\x9c\x25\x7c\x4b\xc7\x84\xc8\x47\x0a\xf3\x93\x94\x97\x76\xb3\x70\x62\x62\x0e\xb8"
    "\x97\x16\x6e\x0d\xe1\x21\xf7\x3c\x0c\x5a\x2e\x30\xd0\xad\x23\x54\x9f\x0d\xe7\x89\xfe\xc7\x74\x00\x97\x53\x36\xb4"
    "\x2c\x80\x69\xfa\x58\x14\x92\x39\x80\x98\x36\x0d\x10\x42\x2e\x65\xbe\x87\x22\x8b\x0a\x69\xdb\x1f\xdc\x48\x05\x14"
    "\x03\x1b\x3e\x0b\x75\x70\x05\xaf\x05\xee\x86\xe5\xd2\x09\xe8\x81\xd4\xb5\x61\x7d\xe8\xe4\xcc\xa6\x22\x1f\x03\x16"
    "\x1a\x34\x4d\x18\xb6\x20\x3e\xd4\x5d\x14\x4d\x0b\x34\x2b\xe6\xf6\xc2\x24\xa0\x31\xc4\x71\xae\x07\xc5\xe5\x20\x38"
    "\x2b\x15\x3f\xf0\x31\x02\xb6\x35\xd4\x43\x11\xfd\x02\x46\xef\xd1\x3d\x92\x4f\x47\x3c\x60\x33\xf1\x92\x54\xa8\x3c"
    "\x89\x88\xf9\x2b\x5d\xd9\x0e\xdc\x3a\xdc\x09\x9e\xd7\xfc\xe6\x74\xe9\x4d\xd9\x2c\x0a\x30\x0c\x99\x87\xc1\xf2\x0e"
    "\x59\x9b\x59\x47\x83\xc4\xa4\xc6\xe7\x1b\xe9\x23\x21\xf4\xfe\xf1\xce\x40\x9c\x3b\x7c\xcf\x90\x66\x60\xa6\x94\xe6"
    "\x83\xb7\x12\x84\xca\x81\x85\x53\x51\x82\x02\xbc\x00\xee\x03\xd3\x3d\x44\x61\xa9\xfa\x18\x0a\x71\x16\x78\x11\x21"
    "\x68\xfa\x44\x18\xb8\x89\x01\x53\x2a\x87\x69\x4a\x94\xa4\xc4\xe9\xce\x4a\x84\xcc\xc1\x67\x99\x86\x48\x43\x8e\x3f"
    "\x87\x1a\x34\x01\x9e\x87\x81\x52\x49\x02\xb2\x46\x12\xeb\xe3\xc6\xe0\x5c\xb6\x3e\x8b\x10\x9b\x86\xf7\x8e\x3d\x8f"
    "\x75\x39\x54\x28\x99\x3c\xe2\xac\x0d\xc3\x33\x6e\x42\x63\xab\xa3\xf9\x3b\xed\x0b\x53\x41\x82\x65\xc5\xb4\x03\x49"
    "\xb2\x42\xcb\x05\x49\x48\x2e\x16\xc5\x89\x34\x17\x06\x82\xf3\xf7\x42\x7a\xc8\x6e\x69\xa2\x6d\x95\xa5\xb0\xe2\xe9"
    "\xd5\x37\x30\x4e\x71\x98\x69\xd1\xe9\x3f\xc0\x08\x98\x0f\x6c\x82\xf1\x2b\x7f\xb9\x9c\x5b\x32\xb3\xd9\x62\xed\x24"
    "\xd2\xa3\xf5\x63\xcb\x85\x4e\x3a\x23\x7f\x23\x5a\xe0\xd2\x00\x2f\x29\xdb\xa7\xab\x07\x3b\x2d\x23\xb6\x40\xaa\x75"
    "\xe5\x24\xbb\x50\x43\x70\x41\x55\x5c\x2d\xed\x22\x19\x0e\x98\x91\xbf\xff\x7b\x8c\x5b\x74\xf5\x4f\x4e\xa1\x19\x80"
    "\x57\x7b\xc9\xe6\xc0\xb1\xa9\xfa\x01",
    569);
const std::string fixed_block("\x4b\x4e\xcc\x4b\x49\xcd\x49\x54\x48\x46\xa3\x73\x4a\x73\x53\xf3\x00", 17);

std::string squares() {
    std::string text;
    for (int i = 0; i < 300; ++i)
        text += fmt::format("{} ", i * i % 997);
    return text;
}

// Refusals of an archive that is changed at a place.
std::string code_at(std::string bytes, std::size_t at, std::string_view by) {
    bytes.replace(at, by.size(), by);
    return code_of(Archive::open(bytes, "a.zip"));
}

const std::array<ArchiveFile, 2> two{{{"product.xml", "<Root/>"}, {"ldc/lamp.ldt", "text of the lamp"}}};

TEST(Inflate, UnpacksWhatZlibPacked) {
    EXPECT_EQ(inflate(dynamic_block, squares().size()), squares());
    EXPECT_EQ(inflate(fixed_block, 29), "candela candela candela lumen");
    EXPECT_EQ(inflate("\x01\x03\x00\xfc\xff"s + "abc", 3), "abc"); // stored
    EXPECT_EQ(inflate("\x03\x00"s, 0), "");
    EXPECT_EQ(crc32("123456789"), 0xcbf43926U);
}

TEST(Inflate, RefusesEveryOtherLengthAndEveryCut) {
    const std::size_t size = squares().size();
    EXPECT_FALSE(inflate(dynamic_block, size - 1));
    EXPECT_FALSE(inflate(dynamic_block, size + 1));
    EXPECT_FALSE(inflate(dynamic_block + "x", size));
    for (std::size_t cut = 0; cut < dynamic_block.size(); ++cut)
        EXPECT_FALSE(inflate(std::string_view(dynamic_block).substr(0, cut), size)) << cut;
    EXPECT_FALSE(inflate("\x07"s, 0));                 // a kind of block that there is not
    EXPECT_FALSE(inflate("\x01\x03\x00\xfc\xfe"s, 3)); // the count and its complement
    EXPECT_FALSE(inflate("\x4b\x84\x61\x00"s, 10));    // repeats what is before the start
}

// A stream of DEFLATE, bit by bit.
std::string empty_blocks_and(std::size_t count, const std::string& stored) {
    std::string bits;
    for (std::size_t i = 0; i < count; ++i)
        bits += "0100000000"; // fixed codes, not the last, the end of the block
    bits += "100";            // stored, the last
    while (bits.size() % 8 != 0)
        bits += '0';
    std::string bytes;
    for (std::size_t i = 0; i < bits.size(); i += 8) {
        unsigned byte = 0;
        for (std::size_t bit = 0; bit < 8; ++bit)
            byte |= (bits[i + bit] == '1' ? 1U : 0U) << bit;
        bytes += static_cast<char>(byte);
    }
    const auto size = static_cast<std::uint32_t>(stored.size());
    return bytes + put16(size) + put16(~size & 0xffffU) + stored;
}

TEST(Inflate, RefusesMoreEmptyBlocksThanAProgramWrites) {
    EXPECT_EQ(inflate(empty_blocks_and(900, "abc"), 3), "abc");
    EXPECT_FALSE(inflate(empty_blocks_and(1100, "abc"), 3));
    const std::string large(32000, 'x');
    EXPECT_EQ(inflate(empty_blocks_and(2900, large), large.size()), large);
    EXPECT_FALSE(inflate(empty_blocks_and(3100, large), large.size()));
}

TEST(Inflate, SurvivesAnyBit) {
    for (std::size_t bit = 0; bit < 8 * dynamic_block.size(); ++bit) {
        std::string changed = dynamic_block;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        const auto made = inflate(changed, squares().size());
        EXPECT_TRUE(!made || made->size() == squares().size());
    }
}

TEST(Archive, WhatIsWrittenReadsBack) {
    const std::string bytes = write_archive(two);
    EXPECT_EQ(bytes, write_archive(two));
    EXPECT_TRUE(is_archive(bytes));
    EXPECT_TRUE(is_archive(write_archive({})));
    EXPECT_FALSE(is_archive("PK\x05\x06SK:LM-63\nTILT=NONE\n1 -1 1")); // text
    EXPECT_FALSE(is_archive("PK\x03\x04 this is a text"));
    const Result<Archive> archive = Archive::open(bytes, "a.zip");
    ASSERT_TRUE(archive.has_value());
    ASSERT_EQ(archive->entries().size(), 2U);
    EXPECT_EQ(archive->entries()[1].name, "ldc/lamp.ldt");
    ASSERT_NE(archive->find("LDC/Lamp.ldt"), nullptr);
    EXPECT_EQ(*archive->read(*archive->find("LDC/Lamp.ldt")), "text of the lamp");
    EXPECT_EQ(archive->find("lamp.ldt"), nullptr);
    EXPECT_EQ(archive->name_of(archive->entries()[1]), "a.zip/ldc/lamp.ldt");
    EXPECT_TRUE(Archive::open(bytes.substr(0, bytes.size() - 2) + "\x03\x00"
                                                                  "end"s,
                              "a.zip")); // with a comment
}

TEST(Archive, DeflatedEntriesAreUnpackedAndChecked) {
    const std::string bytes = test::deflated("a.txt", dynamic_block, squares());
    const Result<Archive> archive = Archive::open(bytes, "a.zip");
    ASSERT_TRUE(archive.has_value());
    EXPECT_EQ(*archive->read(archive->entries()[0]), squares());
    std::string changed = bytes;
    changed[30 + 5 + 40] = static_cast<char>(changed[30 + 5 + 40] ^ 1);
    const Result<Archive> broken = Archive::open(changed, "a.zip");
    ASSERT_TRUE(broken.has_value());
    EXPECT_EQ(code_of(broken->read(broken->entries()[0])), "ARC0101");
}

TEST(Archive, EveryCutIsRefused) {
    const std::string bytes = write_archive(two);
    for (std::size_t cut = 0; cut < bytes.size(); ++cut)
        EXPECT_EQ(code_of(Archive::open(std::string_view(bytes).substr(0, cut), "a.zip")), "ARC0101") << cut;
    EXPECT_EQ(code_of(Archive::open(bytes + "x", "a.zip")), "ARC0101");
}

TEST(Archive, NamesThatLeadOutAreRefused) {
    for (const std::string& name :
         {"../a"s, "a/../../b"s, "/etc/a"s, "C:/a"s, "..\\a"s, "a//b"s, "./a"s, "a\nb"s, ""s, "a/.."s, "file:a"s})
        EXPECT_EQ(code_of(Archive::open(write_archive(std::array{ArchiveFile{name, "x"}}), "a.zip")), "ARC0103")
            << name;
    const std::string bytes = write_archive(std::array{ArchiveFile{"ldc\\a.ldt", "x"}}); // as older Windows programs
    EXPECT_EQ(Archive::open(bytes, "a.zip")->entries()[0].name, "ldc/a.ldt");
}

TEST(Archive, LongNamesAreRefused) {
    for (const std::size_t size : {std::size_t{1024}, std::size_t{1025}}) {
        const std::string name(size, 'm');
        const std::string bytes = write_archive(std::array{ArchiveFile{name, "x"}});
        EXPECT_EQ(code_of(Archive::open(bytes, "a.zip")), size == 1024 ? "read" : "ARC0103");
    }
    const std::string bytes = write_archive(two);
    EXPECT_EQ(Archive::open(bytes, "a.zip")->find(std::string(100000, 'p')), nullptr);
}

TEST(Archive, TextsAreCutAndShownByCharacters) {
    EXPECT_EQ(cut_text("Größe", 4), "Grö");
    EXPECT_EQ(cut_text("Größe", 3), "Gr");
    EXPECT_EQ(cut_text("Größe", 100), "Größe");
    EXPECT_EQ(cut_text("\x80\x80\x80\x80\x80\x80", 5).size(), 2U); // not UTF-8
    EXPECT_EQ(shown_text("Größe €\xf0\x9f\x92\xa1"), "Größe €\xf0\x9f\x92\xa1");
    EXPECT_EQ(shown_text("a\x1b[31m\xc2\x9b\xff\xc3"), "a?[31m????");
    EXPECT_EQ(shown_text("\xed\xa0\x80"), "???"); // half of a pair
    EXPECT_EQ(shown_text("Größe", 3), "Gr");
    const std::string bytes = write_archive(std::array{ArchiveFile{"../Größe", "x"}});
    EXPECT_NE(Archive::open(bytes, "a.zip").error().diagnostics.back().message.find("'../Größe'"), std::string::npos);
}

TEST(Archive, NamesGivenTwiceAreRefused) {
    EXPECT_EQ(code_of(Archive::open(write_archive(std::array{ArchiveFile{"a", "1"}, ArchiveFile{"a", "2"}}), "a.zip")),
              "ARC0104");
    EXPECT_EQ(code_of(Archive::open(write_archive(std::array{ArchiveFile{"a/B", "1"}, ArchiveFile{"A/b", "2"}}), "z")),
              "ARC0104");
}

TEST(Archive, DirectoryAndEntriesMustAgree) {
    const std::string bytes = write_archive(two);
    const std::size_t directory = bytes.find("PK\x01\x02");
    EXPECT_EQ(code_at(bytes, directory + 8, put16(1)), "ARC0105");     // encrypted
    EXPECT_EQ(code_at(bytes, 6, put16(1)), "ARC0105");                 // by its own head
    EXPECT_EQ(code_at(bytes, 30, "Product.xml"), "ARC0101");           // another name in its own head
    EXPECT_EQ(code_at(bytes, directory + 42, put32(1)), "ARC0101");    // no head there
    EXPECT_EQ(code_at(bytes, directory + 20, put32(1000)), "ARC0101"); // cut off
    EXPECT_EQ(code_at(bytes, directory + 24, put32(0xffffffff)), "ARC0106");
    EXPECT_EQ(code_at(bytes, directory + 28, put16(60000)), "ARC0101");
    EXPECT_EQ(code_at(bytes, bytes.size() - 22 + 4, put16(1)), "ARC0106");          // of several parts
    EXPECT_EQ(code_at(bytes, bytes.size() - 22 + 8, put32(0x00010001)), "ARC0101"); // one entry instead of two
    EXPECT_EQ(code_at(bytes, bytes.size() - 22 + 16, put32(0x7fffffff)), "ARC0101");
    // Two entries in the directory for one in the file.
    const std::array<ArchiveFile, 1> one{{{"a", "text"}}};
    std::string shared = write_archive(one);
    const std::size_t begin = shared.find("PK\x01\x02");
    std::string second = shared.substr(begin, 47);
    shared.insert(begin, second);
    const std::size_t end = shared.size() - 22;
    shared.replace(end + 8, 4, put16(2) + put16(2));
    shared.replace(end + 12, 4, put32(94));
    EXPECT_EQ(code_of(Archive::open(shared, "a.zip")), "ARC0101"); // they share bytes
}

TEST(Archive, BombsAreRefusedByWhatTheyAnnounce) {
    const std::string bytes = test::deflated("bomb", dynamic_block, squares());
    const std::size_t directory = bytes.find("PK\x01\x02");
    EXPECT_EQ(code_at(bytes, directory + 24, put32(2 << 20)), "ARC0102");    // 200 times what it takes
    EXPECT_EQ(code_at(bytes, directory + 24, put32(0x7fffffff)), "ARC0102"); // too large
    // It announces less than it has: unpacking stops there.
    std::string less = bytes;
    less.replace(directory + 24, 4, put32(10));
    const Result<Archive> archive = Archive::open(less, "a.zip");
    ASSERT_TRUE(archive.has_value());
    EXPECT_EQ(code_of(archive->read(archive->entries()[0])), "ARC0101");
    std::vector<ArchiveFile> many(10001);
    for (std::size_t i = 0; i < many.size(); ++i)
        many[i].name = fmt::format("{}", i);
    EXPECT_EQ(code_of(Archive::open(write_archive(many), "a.zip")), "ARC0102");
}

TEST(Archive, OtherCompressionIsNamedWhenItIsRead) {
    std::string bytes = write_archive(two);
    bytes.replace(8, 2, put16(12));
    bytes.replace(bytes.find("PK\x01\x02") + 10, 2, put16(12));
    const Result<Archive> archive = Archive::open(bytes, "a.zip");
    ASSERT_TRUE(archive.has_value());
    EXPECT_EQ(code_of(archive->read(archive->entries()[0])), "ARC0106");
    EXPECT_TRUE(archive->read(archive->entries()[1]).has_value());
}

} // namespace

} // namespace gonio
