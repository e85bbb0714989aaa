// Certificates of first contacts of two bodies that move.

#include "tetracone/tetratree/certificate/certificate_data.h"
#include "tetracone/tetratree/certificate/motion_cover.h"
#include "tetracone/tetratree/certificate/windings.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace tetracone {

using tetratree::add_key;
using tetratree::add_list;
using tetratree::fail_proof;
using tetratree::json_text;

bool Certificate::first_contact(const Motion& a, const Motion& b, Question question,
                                const std::optional<First_contact>& answer)
{
  return data_->add(Data::begin("motion"), [&](std::string& text) {
    kernel::require_sound_floating_point();
    add_key(text, "question");
    text += json_text(kernel::to_string(question));
    for (const auto& [name, motion] : {std::pair("a", &a.exact()), std::pair("b", &b.exact())})
      for (std::size_t k = 0; k < 2; ++k) {
        const std::string key = std::string(k == 0 ? "from_" : "to_") + name;
        if (motion->ends())
          tetratree::add_pose(text, key, (*motion->ends())[k]);
        else
          tetratree::add_rigid_pose(text, key, motion->rigid_ends()[k]);
      }
    add_key(text, "answer");
    if (answer)
      add_list(text, std::array{answer->lo, answer->hi}, [](double t) { return json_text(kernel::shortest(t)); });
    else
      text += "null";
    tetratree::Moving_pair moving(data_->groups(), {a.exact(), b.exact()});
    if (answer) {
      std::string witness = "{";
      if (cover_or_meet(witness, moving.at(answer->hi))) {
        // The witness is the only key; its time stands first in it.
        const std::string key = "\"witness\":{";
        text += ",\"witness\":{\"time\":" + json_text(kernel::to_string(kernel::Rational(answer->hi))) + "," +
                witness.substr(1 + key.size());
      } else if (answer->hi != 0 ||
                 !(add_one_winding(text, moving.at(0), 0) || add_one_winding(text, moving.at(0), 1))) {
        return false;
      }
      if (answer->hi == 0) return true;
    }
    tetratree::Motion_cover cover(moving, answer ? answer->lo : 1, answer && answer->lo == answer->hi);
    if (!cover()) return false;
    add_cover(text, cover.cover());
    if (question == Question::solid && !add_all_windings(text, moving.at(0)))
      fail_proof("the answer is not proved: shells");
    return true;
  });
}

}  // namespace tetracone
