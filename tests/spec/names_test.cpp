// Words of enumerations: each table has all values, in order, and each word means one of them.
#include "tests/spec/names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/spec/raster_state.h"
#include "model/spec/reciprocal/schemes.h"

namespace pineda::spec {
namespace {

TEST(Names, EachTableHasItsEnumerationInOrderAndWordsThatDiffer) {
  EXPECT_EQ(fault(kSwitchNames, true), "");
  EXPECT_EQ(fault(kCullNames, Cull::kFront), "");
  EXPECT_EQ(fault(kShadeNames, Shade::kFlat), "");
  EXPECT_EQ(fault(kDepthFuncNames, DepthFunc::kAlways), "");
  EXPECT_EQ(fault(kReciprocalSchemes, ReciprocalScheme::kNone), "");
  EXPECT_EQ(fault(kSetupStyleNames, SetupStyle::kSerial), "");
}

TEST(Names, MutantsOfATableAreSeen) {
  const Name<Cull> exchanged[] = {
      {Cull::kBack, "back"}, {Cull::kNone, "none"}, {Cull::kFront, "front"}};
  EXPECT_EQ(fault(exchanged, Cull::kFront), "order: back");
  const Name<Cull> repeated[] = {
      {Cull::kNone, "none"}, {Cull::kBack, "back"}, {Cull::kFront, "back"}};
  EXPECT_EQ(fault(repeated, Cull::kFront), "twice: back");
  const Name<Cull> shorter[] = {{Cull::kNone, "none"}, {Cull::kBack, "back"}};
  EXPECT_EQ(fault(shorter, Cull::kFront), "not all values");
}

template <class Value>
int round_trips() {
  int good = 0;
  for (const Value value : values_of<Value>()) good += named<Value>(name_of(value)) == value;
  return good;
}

TEST(Names, EachWordIsReadBackAndNoOther) {
  EXPECT_EQ(round_trips<bool>(), 2);
  EXPECT_EQ(round_trips<Cull>(), 3);
  EXPECT_EQ(round_trips<DepthFunc>(), 9);
  EXPECT_EQ(round_trips<ReciprocalScheme>(), 5);
  EXPECT_EQ(named<DepthFunc>("lequal"), DepthFunc::kLequal);
  for (const char* word : {"", "Less", "less ", "les", "lessx"}) {
    EXPECT_FALSE(named<DepthFunc>(word)) << word;
  }
}

TEST(Names, ListsAreInTheOrderOfTheEnumeration) {
  EXPECT_EQ(words_of<Cull>(), "none, back, front");
  EXPECT_EQ(alternatives<Cull>(), "none, back or front");
  EXPECT_EQ(alternatives<Shade>(), "smooth or flat");
  EXPECT_EQ(word_list<bool>(), (std::vector<std::string>{"off", "on"}));
  EXPECT_EQ(joined({"one"}, ", ", " or "), "one");
  EXPECT_EQ(joined({}, ", ", " or "), "");
}

TEST(Names, ANumberThatIsNoValueIsRefused) {
  EXPECT_THROW(name_of(static_cast<Cull>(3)), std::out_of_range);
  EXPECT_THROW(name_of(static_cast<SetupStyle>(-1)), std::out_of_range);
}

}  // namespace
}  // namespace pineda::spec
