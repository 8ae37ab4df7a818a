// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory runs out from each request for it on in turn; later results are those of a fresh
// computation.
#include <gtest/gtest.h>

#include "testing/contact_times_testing.h"
#include "testing/live_objects_testing.h"
#include "testing/replaced_new.h"
#include "world/stopping/contact_times.h"

namespace link_bounds {
namespace {

std::string cartOnRail() {
  const std::string along = R"(<axis xyz="1 0 0"/>
    <limit lower="-9" upper="9" effort="1" velocity="0.5"/>)";
  return "<robot name=\"cart\"><link name=\"rail\"/>" + sphere("cart", 0.1) +
         joint("prismatic", "rail", "cart", along) + "</robot>";
}

class Cart : public MovingRobot {
 public:
  Cart() : MovingRobot(cartOnRail(), parametersOf("rail", 20)) { stand(*this, {0}); }

  /// Boxes at these places on the rail.
  void put(const std::vector<double>& places) {
    scene().objects.removeAll();
    for (const double place : places) {
      ObjectContent content = boxIn("rail");
      const int id = static_cast<int>(place);
      content.bounded.name = "box/" + std::to_string(id);
      content.bounded.shapes.front().link_from_shape.translation().x() = place;
      scene().objects.put({"box", id}, std::move(content), ros::Time(kStamp));
    }
  }

  /// Nothing if memory runs out after so many requests for it.
  std::optional<EarliestContactArray> computed(ContactTimes& contacts, long until_failure = -1) {
    const auto goes_on = [] { return false; };
    const auto past = copy();
    replaced_new::until_failure = until_failure;
    std::optional<EarliestContactArray> result;
    try {
      result = contacts.compute(*past, rules_, nullptr, {}, goes_on)->array;
    } catch (const std::bad_alloc&) {
    }
    replaced_new::until_failure = -1;
    return result;
  }

 private:
  StopRules rules_{model()};
};

ContactTimes newContacts() {
  return ContactTimes({[](const auto&, const auto&) {}, [](const auto&) {}});
}

TEST(ContactTimes, OutOfMemoryLeavesNothingWrong) {
  Cart cart;
  long count = 0;
  for (bool has_failed = true; has_failed; ++count) {
    ContactTimes contacts = newContacts();
    cart.put({2, 4, 6});
    cart.computed(contacts);
    cart.put({3, 5, 7, 8, 9});
    has_failed = !cart.computed(contacts, count);
    cart.put({1, 3, 5, 7, 8, 9});
    ContactTimes others = newContacts();
    ASSERT_EQ(*cart.computed(contacts), *cart.computed(others)) << count;
  }
  EXPECT_GT(count, 10) << "so many requests were refused";
}

}  // namespace
}  // namespace link_bounds
