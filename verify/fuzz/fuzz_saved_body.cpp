// Changes any words of a saved body and repairs its checksum. The result must be refused with an Error. Else its tree
// must answer as all pairs of elements of its vertices and faces do in rational arithmetic.

#include "tetracone/kernel/number/error.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/body_file.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/fuzz/scratch_file.h"
#include "verify/test/support/forged_body.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

using namespace tetracone;
using kernel::Pose;
using kernel::Question;

namespace {

using verify::same;

const verify::Scratch_file& file()
{
  static const verify::Scratch_file scratch(".body");
  return scratch;
}

/// Bodies as `save_body` writes them: a tetrahedron, a cube of polygons, a cube with a tunnel, whose faces have holes,
/// and 32 triangles.
std::vector<std::string> saved_bodies()
{
  verify::scenes::Random random(1);
  std::vector<std::string> all;
  for (const covering::Polyhedron& p :
       {verify::scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), verify::scenes::unit_cube(),
        verify::scenes::cube_with_tunnel(), verify::scenes::blob(random, 1, 0.7, 1.3)}) {
    const tetracone::detail::Body_data body(p, tetracone::detail::legal_triangles(p, {}, "body"));
    body.bvh8().make_all();
    tetracone::detail::write_body_file(body, file().path());
    std::ifstream in(file().path(), std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

/// The ends of the gap in a saved body between its arrays and its nodes: zeros without meaning.
constexpr std::size_t arrays_end = 4096, nodes_begin = 65536;

/// Applies the changes. Eleven bytes select each one: the word, its length of four bytes or eight, the operation, and
/// the operand.
std::string changed(std::string bytes, const std::uint8_t* data, std::size_t size)
{
  for (; size >= 11; data += 11, size -= 11) {
    const std::size_t words = (arrays_end + bytes.size() - nodes_begin) / 4;
    std::size_t at = 4 * ((data[0] | std::size_t(data[1]) << 8) % words);
    if (at >= arrays_end) at += nodes_begin - arrays_end;
    const std::size_t length = (data[2] & 1) != 0 && at + 8 <= bytes.size() ? 8 : 4;
    std::uint64_t word = 0, change = 0;
    std::memcpy(&word, &bytes[at], length);
    std::memcpy(&change, data + 3, 8);
    word = (data[2] & 6) == 0 ? change : (data[2] & 6) == 2 ? word ^ change : word + change;
    std::memcpy(&bytes[at], &word, length);
  }
  return verify::forged(std::move(bytes));
}

}  // namespace

void tetracone::verify::fuzz_saved_body(const std::uint8_t* data, std::size_t size)
{
  static const std::vector<std::string> saved = saved_bodies();
  if (size == 0) return;
  const std::string bytes = changed(saved[data[0] % saved.size()], data + 1, size - 1);
  file().write(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::shared_ptr<const tetracone::detail::Body_data> body;
  try {
    body = tetracone::detail::read_body_file(file().path());
  } catch (const Error&) {
    return;
  }
  same(body->is_closed() == covering::is_closed(body->polyhedron));
  static const covering::Polyhedron probe =
      scenes::tetrahedron({0.25, 0.25, 0.25}, {2, 0.5, 0.25}, {0.5, 2, 1}, {0, 1, 2});
  static const tetratree::Bvh8 fast_probe(probe);
  static const Brute_body truth_of_probe(probe);
  const Brute_body truth(body->polyhedron);
  tetratree::Bvh8_collision first(body->bvh8(), fast_probe), second(fast_probe, body->bvh8());
  for (const double shift : {0.0, 0.75, -1.0, 1e3}) {
    const Pose pose(std::array<double, 12>{0.8, -0.6, 0, shift, 0.6, 0.8, 0, 0.25 * shift, 0, 0, 1, 0});
    for (const Question question : {Question::surface, Question::solid}) {
      if (question == Question::solid && !body->is_closed()) continue;
      const bool expected = collide(truth, Pose(), truth_of_probe, pose, question);
      same(first(Pose(), pose, question) == expected);
      same(second(pose, Pose(), question) == expected);
    }
  }
}
