// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "palpate/scenario/archive.h"
#include "palpate/scenario/container.h"
#include "palpate/scenario/manifest.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;
using scenario::pack_container;
using scenario::read_container;
using scenario::unpack_container;
using scenario::write_container;

namespace {

Array make_floats(std::vector<double> numbers) {
  Array array{Dtype::f8, {static_cast<std::int64_t>(numbers.size())}, Bytes(8 * numbers.size())};
  std::memcpy(array.bytes.data(), numbers.data(), array.bytes.size());
  return array;
}

Container make_container() {
  Container made{"organ", 3, R"({"name":"liver","scale":0.1})", {}, ""};
  made.arrays["mesh/vertices"] = make_floats({0.5, -1.25, 3.0});
  made.arrays["fixed"] = {Dtype::i4, {0}, {}};
  made.arrays["source.obj"] = {Dtype::u1, {2, 2}, {1, 2, 3, 4}};
  return made;
}

bool is_same(const Container& a, const Container& b) {
  return a.format == b.format && a.version == b.version && a.content == b.content &&
         a.arrays == b.arrays;
}

Container unpack(const Bytes& bytes, int newest = 3) {
  return unpack_container(bytes, "a.organ", "organ", newest);
}

Bytes replace(Bytes bytes, const std::string& from, const std::string& to) {
  REQUIRE(from.size() == to.size());
  const auto at = std::search(bytes.begin(), bytes.end(), from.begin(), from.end());
  REQUIRE(at != bytes.end());
  std::copy(to.begin(), to.end(), at);
  return bytes;
}

std::string digest_of(const Container& container, const std::string& name) {
  return scenario::compute_sha256(container.arrays.at(name).bytes);
}

}  // namespace

TEST_CASE("a container comes back from its file as it was") {
  const Folder folder("container");
  const Container made = make_container();

  write_container(folder.file("liver.organ"), made);
  const Container found = read_container(folder.file("liver.organ"), "organ", 3);

  CHECK(is_same(found, made));
  CHECK(contains(found.written_by, "palpate "));
  CHECK(folder.count() == 1);
}

TEST_CASE("equal containers are equal bytes") {
  Container backwards{"organ", 3, R"( {"scale": 1e-1, "name":"liver"} )", {}, "another program"};
  const Container made = make_container();
  for (auto at = made.arrays.rbegin(); at != made.arrays.rend(); ++at) {
    backwards.arrays.insert(*at);
  }

  CHECK(pack_container(backwards) == pack_container(made));
}

TEST_CASE("every cut is refused") {
  const Bytes whole = pack_container(make_container());

  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK_THROWS_AS(unpack(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))),
                    FileError);
  }
}

TEST_CASE("every flipped bit is refused or changes nothing") {
  const Container made = make_container();
  const Bytes whole = pack_container(made);

  const std::string written_by = unpack(whole).written_by;

  int refused = 0, harmless = 0;
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    Bytes flipped = whole;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1 << (bit % 8));
    try {
      const Container found = unpack(flipped);
      if (!is_same(found, made) || found.written_by != written_by) {
        FAIL_CHECK("bit ", bit, " changed the contents unseen");
      }
      ++harmless;
    } catch (const FileError&) {
      ++refused;
    }
  }

  // what nobody reads: dates, the version of zip that made it, the system it was made on
  CHECK(refused > 5 * harmless);
}

TEST_CASE("an array whose SHA-256 is another's is refused though every checksum of zip holds") {
  const Container made = make_container();
  const Bytes whole = pack_container(made);
  const Bytes text = scenario::ArchiveReader(whole, "").read("manifest.json");
  const Bytes forged = replace(text, digest_of(made, "mesh/vertices"), digest_of(made, "fixed"));
  std::vector<scenario::Stored> files = {{"manifest.json", forged}};
  for (const auto& [name, array] : made.arrays) files.push_back({name, array.bytes});

  const std::string sentence = refusal([&] { unpack(scenario::pack_archive(files)); });

  CHECK(contains(sentence, "a.organ: mesh/vertices: got SHA-256 "));
  CHECK(contains(sentence, "as the manifest says"));
}

TEST_CASE("a newer version is refused with a word about newer programs") {
  const Bytes whole = pack_container(make_container());

  const std::string sentence = refusal([&] { unpack(whole, 2); });

  CHECK(contains(sentence, "manifest.json.version: got 3, expected 2 or older"));
  CHECK(contains(sentence, "newer program"));
}

TEST_CASE("an older version comes as it is") {
  CHECK(unpack(pack_container(make_container()), 9).version == 3);
}

TEST_CASE("a file of the other format is refused") {
  const Bytes whole = pack_container(make_container());

  const std::string sentence = refusal([&] { unpack_container(whole, "a.palpate", "palpate", 3); });

  CHECK(contains(sentence, "a.palpate: manifest.json.format: got \"organ\", expected \"palpate\""));
}

TEST_CASE("what a reader would refuse is not written") {
  const auto refused = [](auto change) {
    Container made = make_container();
    change(made);
    return bad_argument([&] { pack_container(made); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  CHECK(contains(refused([&](Container& c) {
                   c.arrays["a"] = make_floats({1.0, nan});
                 }),
                 "a: got number 1 that is infinite or not a number"));
  CHECK(contains(refused([&](Container& c) { c.arrays["a"] = make_floats({-infinity}); }),
                 "a: got number 0 that is infinite"));
  CHECK(contains(refused([](Container& c) { c.arrays["a"].shape = {3}; }), "expected 3"));
  CHECK(contains(refused([](Container& c) { c.arrays["a"].shape = {-1}; }), "a smaller shape"));
  CHECK(contains(refused([](Container& c) {
                   c.arrays["a"].shape = {std::int64_t{1} << 62, std::int64_t{1} << 62};
                 }),
                 "a smaller shape"));
  CHECK(contains(refused([](Container& c) {
                   c.arrays["a"] = {Dtype::u1, {}, {7}};
                 }),
                 "arrays.a.shape: got a list of 0"));
  CHECK(contains(refused([](Container& c) { c.content = "[]"; }), "expected an object"));
  CHECK(contains(refused([](Container& c) { c.content = "{\"a\":NaN}"; }), "not JSON"));
  CHECK(contains(refused([](Container& c) { c.content = "{\"a\":1e999}"; }), "too large"));
  CHECK(contains(refused([](Container& c) { c.content = "{\"a\":1,\"a\":1}"; }), "two members"));
  CHECK(contains(refused([](Container& c) { c.content = "{\"a\":\"\xff\"}"; }), "not JSON"));
  CHECK(contains(refused([](Container& c) { c.version = 0; }), "version: got 0"));
  for (const char* name : {"", "/a", "../a", "a/../b", "a//b", "a/", "A", "a\\b", ".a", "a b",
                           "manifest.json", "\xc3\xa9"}) {
    CAPTURE(name);
    CHECK(contains(refused([&](Container& c) { c.arrays[name] = {}; }), "the name"));
  }
}

TEST_CASE("JSON deeper than the limit is refused, as deep as the limit it is taken") {
  const auto nest = [](int depth) {
    Container made = make_container();
    made.content = "{\"a\":" + std::string(static_cast<std::size_t>(depth), '[') +
                   std::string(static_cast<std::size_t>(depth), ']') + "}";
    return made;
  };

  // the manifest and its content are the two objects around the lists
  CHECK(contains(bad_argument([&] { pack_container(nest(scenario::kMostDepth - 1)); }),
                 "values within more than 64 others"));
  CHECK(unpack(pack_container(nest(scenario::kMostDepth - 2))).content ==
        nest(scenario::kMostDepth - 2).content);
  CHECK_THROWS_AS(pack_container(nest(1000000)), std::invalid_argument);
}

TEST_CASE("what is not a file is refused, and nothing is left behind where writing fails") {
  const Folder folder("not-a-file");

  CHECK(contains(refusal([&] { read_container(folder.file("none"), "organ", 1); }), "none"));
  CHECK(contains(refusal([&] { read_container(folder.file("."), "organ", 1); }), "file"));
  CHECK(contains(
      refusal([&] { write_container(folder.file("no/such/folder.organ"), make_container()); }),
      "no/such/folder.organ"));
  std::filesystem::create_directory(folder.file("taken"));
  CHECK(contains(refusal([&] { write_container(folder.file("taken"), make_container()); }),
                 "taken: got "));
  CHECK(folder.count() == 1);
}

TEST_CASE("a link to a file stays a link when the file is written") {
  const Folder folder("link");
  std::filesystem::create_symlink("real.organ", folder.file("link.organ"));

  write_container(folder.file("link.organ"), make_container());

  CHECK(std::filesystem::is_symlink(folder.file("link.organ")));
  CHECK(is_same(read_container(folder.file("real.organ"), "organ", 3), make_container()));
}
