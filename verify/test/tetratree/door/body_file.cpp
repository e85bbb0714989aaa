#include "tetracone/tetratree/door/body_file.h"

#include "tetracone/tetratree/door/checksum.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "verify/fuzz/scratch_file.h"
#include "verify/test/support/forged_body.h"
#include "verify/test/support/said.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_body_file)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;
using tetracone::tetratree::Bvh8_node;

namespace {

std::string bytes_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// A body as it is read from where it was saved.
Body saved(const Body& body)
{
  const verify::Temporary_file file("saved.body", "");
  save_body(body, file.path());
  return read_body(file.path());
}

/// Returns the message with which these bytes are refused, after the file's name; empty when they are not.
std::string refusal(const std::filesystem::path& file, const std::string& bytes)
{
  write(file, bytes);
  const std::string line = verify::said([&] { read_body(file); }), name = file.string();
  return line.starts_with(name) ? line.substr(name.size()) : line;
}

/// As `refusal` has them.
bool is_one_line(const std::string& refused)
{
  return refused.starts_with(": ") && refused.find("; expected ") != std::string::npos &&
         refused.find('\n') == std::string::npos;
}

Polyhedron blob(int divisions, unsigned seed)
{
  scenes::Random random(seed);
  return scenes::blob(random, divisions, 0.7, 1.3);
}

Polyhedron open_box() { return scenes::without_last_face(scenes::unit_cube()); }

/// Triangles, polygons, faces with a hole, and a surface that is open.
std::vector<Body> bodies()
{
  const std::string frame = TETRACONE_SOURCE_DIR "/verify/test/models/frame.poly";
  return {Body(scenes::unit_cube()), Body(open_box()), Body(blob(4, 1)), read_body(frame),
          tetracone::triangulated_body(read_body(frame).polyhedron())};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_saved_body_answers_as_the_one_that_was_saved)
{
  const Body probe(blob(2, 2));
  for (const Body& made : bodies()) {
    const Body read = saved(made);
    BOOST_TEST(read.is_closed() == made.is_closed());
    BOOST_TEST((read.polyhedron().vertices == made.polyhedron().vertices));
    const Question question = made.is_closed() ? Question::solid : Question::surface;
    Query of_made(made, probe, question), of_read(read, probe, question), of_both(read, made, question);
    for (int k = 0; k < 20; ++k) {
      const Pose pose({0.8, -0.6, 0, 0.1 * k, 0.6, 0.8, 0, 0.05 * k, 0, 0, 1, 0.01 * k});
      const auto answer = of_made.collide(Pose(), pose);
      BOOST_TEST((of_read.collide(Pose(), pose).relation() == answer.relation()));
      BOOST_TEST(of_read.certified_gap() == of_made.certified_gap());
      BOOST_TEST(of_read.distance(Pose(), pose) == of_made.distance(Pose(), pose));
      if (k % 5 != 0) continue;
      BOOST_TEST((of_read.features(Pose(), pose) == of_made.features(Pose(), pose)));
      BOOST_TEST(of_read.contacts(Pose(), pose).size() == of_made.contacts(Pose(), pose).size());
      BOOST_TEST(bool(of_both.collide(Pose(), Pose())));
    }
    const tetracone::Ray ray{{-3, 0.4, 0.3}, {1, 0.01, 0.02}};
    const auto of_ray = made.hits(ray), of_read_ray = read.hits(ray);
    BOOST_REQUIRE(of_ray.size() == of_read_ray.size());
    for (std::size_t k = 0; k < of_ray.size(); ++k)
      BOOST_TEST((of_ray[k].face == of_read_ray[k].face && of_ray[k].t == of_read_ray[k].t));
    if (made.is_closed()) BOOST_TEST((read.inside({0.3, 0.2, 0.1}) == made.inside({0.3, 0.2, 0.1})));
  }
}

BOOST_AUTO_TEST_CASE(every_body_can_be_read_again)
{
  scenes::Random random(7);
  std::vector<scenes::Named> all = scenes::closed_bodies();
  all.push_back({"large", blob(6, 8)});
  all.push_back({"open", open_box()});
  all.push_back({"anywhere", scenes::random_tetrahedra(random, 200, 9)});
  for (const double scale : {0x1p-1060, 0x1p-200, 0x1p300, 0x1p1000})
    all.push_back({"scaled", scenes::moved(scenes::random_tetrahedra(random, 50, 9), scale)});
  all.push_back({"far", scenes::moved(blob(3, 9), 0x1p-30, {0.7, 1e3, -3})});
  Polyhedron dots, ever_smaller, needles;
  dots.vertices = {{1, 2, 3}, {1, 2, 3}, {4, 4, 4}};
  for (const auto& loop : {std::vector<std::uint32_t>{0}, {1}, {0, 1}, {2, 0, 1}}) dots.add_polygon(loop);
  all.push_back({"dots", dots});
  for (int k = 0; k < 400; ++k) {
    append(ever_smaller, scenes::moved(scenes::cube(1), std::ldexp(1.0, -2 * k), {std::ldexp(8.0, -2 * k), 0, 0}));
    append(needles, scenes::box({0.01 * k, 0, 0}, {0.01 * k + std::ldexp(1.0, -k), 1e3, std::ldexp(1.0, -k / 2)}));
  }
  all.push_back({"ever smaller", ever_smaller});
  all.push_back({"needles", needles});
  for (const auto& [name, polyhedron] : all) BOOST_TEST_CONTEXT(name)
    {
      for (const Body& body : {Body(polyhedron), Body(scenes::triangulated(polyhedron))}) {
        BOOST_TEST(verify::said([&] { saved(body); }) == "");
      }
    }
}

BOOST_AUTO_TEST_CASE(a_body_is_the_same_bytes_whenever_it_is_saved)
{
  const verify::Temporary_file first("first.body", ""), second("second.BODY", "");
  for (const Body& body : bodies()) {
    save_body(body, first.path());
    const Body asked(body.polyhedron());  // some of whose nodes are made by queries
    if (body.polyhedron().face_count() > 100) {
      Query(asked, Body(blob(2, 2)), Question::surface).collide(Pose(), Pose::translation(0.9, 0.1, 0));
      save_body(asked, second.path());
      BOOST_TEST((bytes_of(second.path()) == bytes_of(first.path())));
    }
    save_body(read_body(first.path()), second.path());
    BOOST_TEST((bytes_of(second.path()) == bytes_of(first.path())));
  }
}

BOOST_AUTO_TEST_CASE(a_file_may_go_and_threads_may_share_it_while_the_body_is_asked)
{
  const Body body(blob(3, 3)), read = saved(body), copy = saved(read);
  std::vector<int> collisions(3, 0);
  std::vector<std::thread> threads;
  for (int& count : collisions)
    threads.emplace_back([&] {
      Query query(read, copy);
      for (int k = 0; k < 30; ++k) count += bool(query.collide(Pose(), Pose::translation(0.1 * k, 0, 0)));
    });
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(collisions[0] > 0);
  BOOST_TEST((collisions[0] == collisions[1] && collisions[1] == collisions[2]));
}

BOOST_AUTO_TEST_CASE(every_spoiled_byte_is_seen)
{
  const verify::Temporary_file file("spoiled.body", "");
  save_body(Body(blob(1, 4)), file.path());
  const std::string whole = bytes_of(file.path());
  BOOST_TEST(refusal(file.path(), whole) == "");
  int seen = 0, spoiled = 0;
  const auto spoil = [&](std::size_t at, int bits) {
    std::string bytes = whole;
    bytes[at] = char(bytes[at] ^ bits);
    ++spoiled;
    const std::string line = refusal(file.path(), bytes);
    seen += is_one_line(line);
  };
  for (std::size_t at = 0; at < 400; ++at) spoil(at, 1 << at % 8);
  for (std::size_t at = 400; at < whole.size(); at += 997) spoil(at, 0x80);
  for (std::size_t back = 1; back <= 64; ++back) spoil(whole.size() - back, 0xff);
  BOOST_TEST(seen == spoiled);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_said)
{
  const verify::Temporary_file file("wrong.body", "");
  save_body(Body(scenes::unit_cube()), file.path());
  const std::string whole = bytes_of(file.path()), size = std::to_string(whole.size());
  const auto with = [&](std::size_t at, char byte) {
    std::string bytes = whole;
    bytes[at] = byte;
    return refusal(file.path(), bytes);
  };
  BOOST_TEST(refusal(file.path(), "") == ": the file is empty; expected a saved body");
  BOOST_TEST(refusal(file.path(), "OFF\n") ==
             ": is no saved body; expected a file that `tetracone save` or save_body wrote");
  BOOST_TEST(refusal(file.path(), whole.substr(0, 100)) ==
             ": has 100 bytes; expected at least the 192 with which a saved body begins");
  BOOST_TEST(with(16, 1) == ": is a saved body of version 1; expected version 2: save it anew");
  BOOST_TEST(with(20, 4) ==
             ": is of a machine with another order of bytes; expected a body saved by such a machine as this one");
  BOOST_TEST(with(24, 25) == ": has 25 bytes for an element of array 0; expected 24: save it anew");
  BOOST_TEST(with(39, 1) == ": has " + size + " bytes; expected more, as its beginning says");
  BOOST_TEST(refusal(file.path(), whole + '\0') ==
             ": has " + std::to_string(whole.size() + 1) + " bytes; expected " + size + ", as its beginning says");
  BOOST_TEST(with(whole.size() - 1, 1) ==
             ": is spoiled: its checksum is not that of its bytes; expected the file as it was saved");
  int refused = 0, cuts = 0;
  for (std::size_t length = 1; length < whole.size(); length += 61, ++cuts)
    refused += refusal(file.path(), whole.substr(0, length)) != "";
  BOOST_TEST(refused == cuts);
}

namespace {

/// A saved body of few bytes, and what forgers make of it.
class Forgery {
 public:
  explicit Forgery(const Body& body)
      : file_(".body"), arrays_(arrays_of(body)), answers_(verify::answers(Body(body.polyhedron())))
  {
    save_body(body, file_.path());
    whole_ = bytes_of(file_.path());
    // Zeros between the arrays and the nodes, which begin at a page, mean nothing.
    const std::size_t page = 65536;
    std::size_t end = whole_.size() > page ? whole_.find_last_not_of('\0', page - 1) + 1 : whole_.size();
    for (std::size_t at = 0; at + 4 <= whole_.size(); at += 4)
      if (at < end + 8 || at >= page) places_.push_back(at);
  }

  const std::string& whole() const { return whole_; }
  const std::vector<std::size_t>& places() const { return places_; }

  /// Reads the bytes with a right checksum. They must be refused in one line, or answer as a body made anew from their
  /// vertices and faces.
  void ask(const std::string& bytes)
  {
    ++asked;
    const std::string changed = verify::forged(bytes);
    if (const std::string line = refusal(file_.path(), changed); !line.empty()) {
      ++refused;
      BOOST_TEST(is_one_line(line), line);
      return;
    }
    const Body read = read_body(file_.path());
    const bool is_same = arrays_of(read) == arrays_;
    BOOST_TEST(verify::answers(read) == (is_same ? answers_ : verify::answers(Body(read.polyhedron()))));
  }

  int asked = 0, refused = 0;

 private:
  /// The bytes of vertices and loops.
  static std::string arrays_of(const Body& body)
  {
    std::string bytes;
    body.polyhedron().for_arrays([&](const auto& array) {
      bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(array[0])).push_back('.');
    });
    return bytes;
  }

  verify::Scratch_file file_;
  std::string arrays_, answers_, whole_;
  std::vector<std::size_t> places_;  // every fourth byte that means something
};

template <class Word>
void put(std::string& bytes, std::size_t at, Word word)
{
  if (at + sizeof word <= bytes.size()) std::memcpy(&bytes[at], &word, sizeof word);
}

/// Another word at this place, of four bytes or eight: one of some that forgers like, or any.
std::string changed(std::string bytes, std::size_t at, int way, std::mt19937_64& random)
{
  std::uint32_t four;
  std::uint64_t eight = 0;
  std::memcpy(&four, &bytes[at], 4);
  std::memcpy(&eight, &bytes[at], std::min<std::size_t>(8, bytes.size() - at));
  constexpr double infinite = std::numeric_limits<double>::infinity(),
                   nothing = std::numeric_limits<double>::quiet_NaN();
  switch (way) {
    case 0: put(bytes, at, std::uint32_t(0)); break;
    case 1: put(bytes, at, ~std::uint32_t(0)); break;
    case 2: put(bytes, at, four + 1); break;
    case 3: put(bytes, at, four - 1); break;
    case 4: put(bytes, at, std::uint32_t(random())); break;
    case 5: put(bytes, at, float(nothing)); break;
    case 6: put(bytes, at, float(infinite)); break;
    case 7: put(bytes, at, four ^ 1u << random() % 32); break;
    case 8: put(bytes, at, 1e30f); break;
    case 9: put(bytes, at, std::uint64_t(0)); break;
    case 10: put(bytes, at, ~std::uint64_t(0)); break;
    case 11: put(bytes, at, nothing); break;
    case 12: put(bytes, at, -infinite); break;
    case 13: put(bytes, at, eight + 1); break;
    case 14: put(bytes, at, 1e308); break;
    case 15: put(bytes, at, random()); break;
    case 16: put(bytes, at, eight ^ std::uint64_t(1) << random() % 64); break;
    case 17: put(bytes, at, float(std::bit_cast<float>(four) * 0.999)); break;
    default: put(bytes, at, std::uint32_t(random() % 16)); break;
  }
  return bytes;
}
constexpr int ways = 19;

Body tetrahedron() { return Body(scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})); }

}  // namespace

BOOST_AUTO_TEST_CASE(any_word_may_be_forged_and_no_answer_is_wrong)
{
  std::mt19937_64 random(1);
  const Body with_holes = read_body(TETRACONE_SOURCE_DIR "/verify/test/models/frame.poly");
  for (const Body& body : {tetrahedron(), Body(scenes::unit_cube()), Body(open_box()), with_holes,
                           tetracone::triangulated_body(with_holes.polyhedron())}) {
    Forgery forgery(body);
    const std::size_t faces = body.polyhedron().face_count();
    const int step = faces > 6 ? ways : faces > 4 ? 10 : 2;  // each word once, or more
    for (const std::size_t at : forgery.places())
      for (int way = int(random() % step); way < ways; way += step)
        forgery.ask(changed(forgery.whole(), at, way, random));
    BOOST_TEST_MESSAGE(forgery.asked << " forged, " << forgery.refused << " refused");
    BOOST_TEST(forgery.refused > forgery.asked / 2);
  }
}

BOOST_AUTO_TEST_CASE(what_is_forged_is_said)
{
  const verify::Temporary_file file("said.body", "");
  save_body(Body(scenes::triangulated(scenes::unit_cube())), file.path());
  const std::string whole = bytes_of(file.path());
  const auto line = [&](std::size_t at, const auto& word) {
    std::string bytes = whole;
    put(bytes, at, word);
    return refusal(file.path(), verify::forged(bytes));
  };
  const std::string as_saved = "; expected a file that `tetracone save` or save_body wrote";
  constexpr std::size_t vertices = 192, corners = vertices + 8 * 24, loops = corners + 192, faces = loops + 64,
                        order = faces + 64, nodes = 65536;
  BOOST_TEST(line(vertices, std::numeric_limits<double>::quiet_NaN()) ==
             ": vertex 0 has the coordinate nan; expected finite coordinates");
  BOOST_TEST(line(corners, 8u).starts_with(": face 0 names vertex 8 of 8 vertices; expected "));
  BOOST_TEST(line(loops, 7u) == ": has loops of other corners, or faces of other loops, than there are" + as_saved);
  BOOST_TEST(line(faces, 0u) == ": has loops of other corners, or faces of other loops, than there are" + as_saved);
  BOOST_TEST(line(order, ~0u) == ": has leaves that do not hold each triangle and each face once" + as_saved);
  BOOST_TEST(line(nodes + 384, 0.01f) == ": lane 0 of node 0 has a box that does not hold its elements" + as_saved);
  // Half of the margin for axes that are not quite orthonormal is too little, though the box still holds its elements.
  std::array<float, 3> extent{};
  for (std::size_t i = 0; i < 3; ++i) std::memcpy(&extent[i], &whole[nodes + 384 + 32 * i], sizeof(float));
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(line(nodes + 384 + 32 * i, extent[i] - 0x1p-20F * std::ranges::max(extent)) ==
               ": lane 0 of node 0 has a box that does not hold its elements" + as_saved);
  BOOST_TEST(line(nodes + 96, 2.0f) == ": lane 0 of node 0 has axes that are not orthonormal" + as_saved);
  for (const float reach : {1e30f, 0.5f})
    BOOST_TEST(line(nodes + 492, reach) == ": lane 0 of node 0 has a box of other numbers than boxes have" + as_saved);
  BOOST_TEST(line(nodes + offsetof(Bvh8_node, child), 2) == ": lane 0 of node 0 does not lead to node 1" + as_saved);
  BOOST_TEST(line(nodes + offsetof(Bvh8_node, first), 1u) == ": lane 0 of node 0 has other elements" + as_saved);
}

BOOST_AUTO_TEST_CASE(a_leaf_says_where_its_triangle_lies)
{
  const verify::Temporary_file file("leaf.body", "");
  save_body(Body(scenes::triangulated(scenes::unit_cube())), file.path());
  const std::string whole = bytes_of(file.path());
  constexpr std::size_t nodes = 65536;
  int leaves = 0, coded = 0;
  for (std::size_t at = nodes; at + sizeof(Bvh8_node) <= whole.size(); at += sizeof(Bvh8_node)) {
    Bvh8_node node;
    std::memcpy(static_cast<void*>(&node), &whole[at], sizeof node);
    for (int lane = 0; lane < node.boxes.lane_count; ++lane) {
      if (!node.is_leaf(lane)) continue;
      ++leaves;
      const auto code = Bvh8_node::apex(node.child[std::size_t(lane)]);
      if (code == 0) continue;
      ++coded;
      // A quarter of the box's side is beyond every tolerance.
      std::string bytes = whole;
      const auto other = tetracone::kernel::Apex_code(code > 0x8000 ? code - 0x4000 : code + 0x4000);
      put(bytes, at + offsetof(Bvh8_node, child) + 4 * std::size_t(lane), Bvh8_node::leaf(other));
      BOOST_TEST(
          refusal(file.path(), verify::forged(bytes))
              .ends_with(
                  " has a triangle elsewhere in its box; expected a file that `tetracone save` or save_body wrote"));
    }
  }
  BOOST_TEST(leaves == 12);
  BOOST_TEST(coded > 6);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_saved_leaves_nothing)
{
  const Body cube(scenes::unit_cube());
  const verify::Temporary_folder folder("nothing");
  BOOST_CHECK_THROW(save_body(cube, folder.path() / "cube.body"), Error);
  std::filesystem::create_directories(folder.path() / "taken.body" / "within");
  BOOST_CHECK_THROW(save_body(cube, folder.path() / "taken.body"), Error);
  BOOST_CHECK_THROW(save_body(cube, folder.path() / "cube.off"), Error);
  BOOST_CHECK_THROW(read_body(folder.path() / "taken.body"), Error);
  BOOST_CHECK_THROW(read_body(folder.path() / "none.body"), Error);
  BOOST_TEST(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

BOOST_AUTO_TEST_CASE(a_checksum_differs_where_one_word_or_the_order_of_two_does)
{
  const auto sum = [](const std::vector<unsigned char>& bytes) {
    tetracone::detail::Checksum checksum;
    checksum.add(std::as_bytes(std::span(bytes)));
    return checksum.value();
  };
  std::vector<unsigned char> bytes(256, 0);
  const auto none = sum(bytes);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
    BOOST_TEST(sum(bytes) != none);
    bytes[bit / 8] = 0;
  }
  bytes[7] = bytes[64 + 7] = 0x80;  // the highest bits of a lane's words do not cancel
  BOOST_TEST(sum(bytes) != none);
  std::vector<unsigned char> one(256, 0), other(256, 0);
  one[0] = other[64] = 1;
  BOOST_TEST(sum(one) != sum(other));
}

BOOST_AUTO_TEST_SUITE_END()
