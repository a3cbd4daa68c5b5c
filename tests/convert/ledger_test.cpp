// The ledger: its JSON whole, and what counts as loss.
#include "convert/ledger.h"

#include <gtest/gtest.h>

namespace yarte::convert {
namespace {

TEST(Ledger, IsWrittenAsJson) {
    Ledger ledger;
    ledger.add({"camera", "apertures", Action::exact, "vectors", {}});
    ledger.add({"body 3", "vertices", Action::approximated, "a \"plane\"", 0.25});
    ledger.add({"file \xff", "", Action::dropped, "", {}});
    EXPECT_EQ(toJson(ledger), R"({
  "schema": 1,
  "rows": [
    {
      "where": "camera",
      "property": "apertures",
      "action": "exact",
      "detail": "vectors",
      "bound": null
    },
    {
      "where": "body 3",
      "property": "vertices",
      "action": "approximated",
      "detail": "a \"plane\"",
      "bound": 0.25
    },
    {
      "where": "file )"
                              "\xEF\xBF\xBD"
                              R"(",
      "property": "",
      "action": "dropped",
      "detail": "",
      "bound": null
    }
  ]
}
)");
}

TEST(Ledger, IsWrittenAsJsonWhenEmpty) { EXPECT_EQ(toJson({}), "{\n  \"schema\": 1,\n  \"rows\": []\n}\n"); }

TEST(Ledger, CountsApproximatedAndDroppedAsLoss) {
    const auto hasLoss = [](Action action) {
        Ledger ledger;
        ledger.add({"a", "b", action, "c", {}});
        return ledger.hasLoss();
    };
    EXPECT_FALSE(Ledger{}.hasLoss());
    EXPECT_FALSE(hasLoss(Action::exact));
    EXPECT_FALSE(hasLoss(Action::extras));
    EXPECT_FALSE(hasLoss(Action::added));
    EXPECT_TRUE(hasLoss(Action::approximated));
    EXPECT_TRUE(hasLoss(Action::dropped));
}

TEST(Ledger, DescribesARowWithItsBound) {
    EXPECT_EQ(describe({"body 3", "vertices", Action::approximated, "moved", 0.5}),
              "body 3: vertices approximated: moved (at most 0.5)");
    EXPECT_EQ(describe({"light 1", "colour", Action::dropped, "grey only", {}}),
              "light 1: colour dropped: grey only");
}

} // namespace
} // namespace yarte::convert
