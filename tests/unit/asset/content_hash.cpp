#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/detail/sha256_blocks.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace gonio {
namespace {

TEST(ContentHash, FollowsTheExamplesOfFips180) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// python3 -c 'import hashlib; h = lambda b: hashlib.sha256(b).hexdigest()
// print(h("".join(h(bytes((37 * i + i // 7) % 256 for i in range(n))) for n in range(200)).encode()))'
TEST(ContentHash, OfEveryLengthAroundABlock) {
    std::string bytes;
    std::string hashes;
    for (std::size_t i = 0; i < 200; ++i) {
        hashes += sha256(bytes);
        bytes += static_cast<char>((37 * i + i / 7) % 256);
    }
    EXPECT_EQ(sha256(hashes), "66a5723c5e71a27d466a4789dea1f5d1d20bf52a664209a8fb44ba9d35eab35c");
}

TEST(ContentHash, IsTheSameByTheProcessorsInstructions) {
    const detail::AddSha256Blocks instructions = detail::sha256_instructions();
    if (instructions == nullptr) GTEST_SKIP() << "the processor has none";
    std::string bytes;
    for (std::size_t i = 0; i < 50 * detail::sha256_block_size; ++i)
        bytes += static_cast<char>((i * i + 7 * i / 3) % 251);
    detail::Sha256State plain{1, 2, 3, 4, 0xfffffff0U, 6, 7, 0x80000000U};
    detail::Sha256State quick = plain;
    for (std::size_t count = 0, first = 0; first + count <= 50; first += count++) {
        detail::add_sha256_blocks(plain, bytes.data() + first * detail::sha256_block_size, count);
        instructions(quick, bytes.data() + first * detail::sha256_block_size, count);
        EXPECT_EQ(quick, plain) << count;
    }
}

} // namespace
} // namespace gonio
