// answers FOLDER [best|avx2|ssse3|none]: every case of a dataset (`tetracone experiment dataset`) asked of the library,
// a line each, the same on every machine. How many answers of the adaptive kernel were wrong goes to standard error.

#include <tetracone/tetracone.h>

#include <hwy/targets.h>
#include <nlohmann/json.hpp>

#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace {

using Json = nlohmann::ordered_json;

/// Leaves out vector instructions beyond those: the library chooses among the rest.
void keep_instructions(const std::string& best)
{
  std::int64_t left_out = 0;
  if (best == "avx2" || best == "ssse3" || best == "none") left_out |= HWY_AVX3 | HWY_AVX3_DL;
  if (best == "ssse3" || best == "none") left_out |= HWY_AVX2 | HWY_SSE4;
  if (best == "none") left_out |= HWY_SSSE3;
  if (left_out == 0 && best != "best")
    throw tetracone::Error("no instructions '" + best + "'; expected best, avx2, ssse3 or none");
  hwy::DisableTargets(left_out);
}

tetracone::Pose pose_of(const Json& row, char body)
{
  std::array<std::string, 12> numbers;
  for (int k = 0; k < 12; ++k) {
    const Json& number = row.at(body + std::to_string(k / 4) + std::to_string(k % 4));
    numbers[k] = number.is_string() ? number.get<std::string>() : number.dump();
  }
  return tetracone::Pose::from_text(numbers);
}

void answer(const std::filesystem::path& folder)
{
  std::ifstream file(folder / "cases.jsonl");
  if (!file) throw tetracone::Error((folder / "cases.jsonl").string() + ": cannot be read; expected a dataset");
  std::map<std::string, tetracone::Body> bodies;
  const auto body = [&](const std::string& name) -> const tetracone::Body& {
    if (const auto found = bodies.find(name); found != bodies.end()) return found->second;
    return bodies.emplace(name, tetracone::read_body(folder / "meshes" / name)).first->second;
  };
  std::size_t asked = 0, wrong = 0;
  for (std::string line; std::getline(file, line);) {
    const Json row = Json::parse(line);
    const tetracone::Body &a = body(row.at("mesh_a")), &b = body(row.at("mesh_b"));
    const tetracone::Pose pose_a = pose_of(row, 'a'), pose_b = pose_of(row, 'b');
    std::cout << row.at("id").get<std::string>();
    for (const auto kernel : {tetracone::Kernel::adaptive, tetracone::Kernel::double_, tetracone::Kernel::float_}) {
      tetracone::Query_options options;
      options.kernel = kernel;
      const auto ask = [&](tetracone::Question question) {
        const tetracone::Answer forth = tetracone::Query(a, b, question, options).collide(pose_a, pose_b);
        const tetracone::Answer back = tetracone::Query(b, a, question, options).collide(pose_b, pose_a);
        std::cout << ' ' << forth.relation() << ' ' << back.relation();
        if (kernel != tetracone::Kernel::adaptive) return;
        const bool truth = row.at(question == tetracone::Question::solid ? "solid" : "surface");
        for (const tetracone::Answer& one : {forth, back}) {
          ++asked;
          wrong += bool(one) != truth;
        }
      };
      ask(tetracone::Question::surface);
      ask(tetracone::Question::solid);
    }
    std::cout << '\n';
  }
  std::cerr << wrong << " of " << asked << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
  try {
    if (argc < 2 || argc > 3) throw tetracone::Error("answers: expected FOLDER [best|avx2|ssse3|none]");
    keep_instructions(argc == 3 ? argv[2] : "best");
    answer(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
