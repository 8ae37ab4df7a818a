// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names of objects, written and parsed.
#include "world/model/object_key.h"

#include <gtest/gtest.h>

#include <limits>

namespace link_bounds {
namespace {

TEST(ObjectKey, NamesAreReadAsTheyAreWritten) {
  for (const ObjectKey& key :
       {ObjectKey{"scene", 0}, ObjectKey{"", 7}, ObjectKey{"a/b", -3}, ObjectKey{"two words", 12},
        ObjectKey{"min", std::numeric_limits<std::int32_t>::min()}}) {
    const auto read = parseObjectName(objectName(key));
    ASSERT_TRUE(read) << objectName(key);
    EXPECT_EQ(*read, key);
  }
  EXPECT_EQ(objectName({"", 7}), "/7");
}

TEST(ObjectKey, OtherTextsAreNoNames) {
  for (const char* text : {"", "scene", "scene/", "scene/x", "scene/1x", "scene/01", "scene/-0",
                           "scene/ 1", "scene/2147483648", "scene/*", "/"}) {
    EXPECT_FALSE(parseObjectName(text)) << text;
  }
}

TEST(ObjectKey, BoxesOfOtherNodesHaveNamesInsteadOfIds) {
  for (const char* box : {"arm", "right/arm", "arm/", "/", "", "held/1", "1", "-0", "two words"}) {
    for (const char* node : {"/bounds", "/right/bounds", "bounds"}) {
      const std::string name = neighbourName(node, box);
      EXPECT_TRUE(isNeighbourName(name)) << name;
      const auto key = parseObjectName(name);
      ASSERT_TRUE(key) << name;
      EXPECT_EQ(objectName(*key), name);
    }
  }
  EXPECT_EQ(*parseObjectName("/right/bounds/arm"), (ObjectKey{"/right/bounds", 0, "arm"}));
  EXPECT_EQ(*parseObjectName("/right/bounds/held/1"), (ObjectKey{"/right/bounds/held", 1}));
  for (const char* name : {"", "/", "arm", "/table", "right/arm", "held/1", "/1"})
    EXPECT_FALSE(isNeighbourName(name)) << name;
}

TEST(ObjectKey, SortedByNamespaceThenById) {
  EXPECT_LT((ObjectKey{"a", 10}), (ObjectKey{"b", 2}));
  EXPECT_LT((ObjectKey{"a", 2}), (ObjectKey{"a", 10}));
  EXPECT_LT((ObjectKey{"a", -1}), (ObjectKey{"a", 0}));
  EXPECT_LT((ObjectKey{"a", 0, "x"}), (ObjectKey{"a", 0, "y"}));
}

}  // namespace
}  // namespace link_bounds
