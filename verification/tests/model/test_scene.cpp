// Which effects a card asks for, and no others.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/host_scene.h"

namespace type21::test {
namespace {

std::vector<Effect> effects(const Fields& fields, Model model = blank_over_tool()) {
    Problems problems;
    resolve_fields(model, fields, problems);
    EXPECT_EQ(problems.error_count(), 0) << to_text(problems.list().front());
    return plan(std::make_shared<const Model>(model)).effects.at(0);
}

using List = std::vector<Effect>;

TEST(Plan, OfABlankCardIsForceAndDamping) {
    // Damping cannot be left out: VISs 0 means 1.
    EXPECT_EQ(effects({}), (List{Effect::elastic, Effect::damping}));
}

TEST(Plan, WithoutStiffnessThereIsNoDamping) {
    EXPECT_EQ(effects({{"Istf", "1"}}), (List{Effect::elastic}));
    EXPECT_EQ(effects({{"Istf", "1"}, {"Stfac", "5.0"}}), (List{Effect::elastic, Effect::damping}));
}

TEST(Plan, EachFieldAsksForItsEffect) {
    const auto extra = [](const Fields& fields, Model model = blank_over_tool()) {
        List list = effects(fields, std::move(model));
        EXPECT_GE(list.size(), 2u);
        list.erase(list.begin(), list.begin() + 2);
        return list;
    };
    EXPECT_EQ(extra({{"Fric", "0.1"}}), List{Effect::friction});
    EXPECT_EQ(extra({{"Ifric", "1"}}), List{Effect::friction}) << "law 1 may rub whatever its numbers";
    EXPECT_EQ(extra({{"Ifric", "4"}}), List{Effect::friction});
    EXPECT_EQ(extra({{"Igap", "2"}}), List{Effect::gap_growth});
    EXPECT_EQ(extra({{"Igap", "2"}, {"Pmax", "600.0"}}), (List{Effect::gap_growth, Effect::pmax_limit}));
    EXPECT_EQ(extra({{"Igap", "2"}, {"Pmax", "1e30"}}), List{Effect::gap_growth});
    EXPECT_EQ(extra({{"Igap", "1"}, {"Pmax", "600.0"}}), List{});
    EXPECT_EQ(extra({{"Iadm", "1"}}), List{Effect::adaptive_data});
    EXPECT_EQ(extra({{"Iadm", "2"}, {"Angladm", "30.0"}}), List{Effect::adaptive_data});
    EXPECT_EQ(extra({{"Idel", "1"}}), List{Effect::deletion});
    EXPECT_EQ(extra({{"Idel", "-2"}}), List{Effect::deletion});
    EXPECT_EQ(extra({{"IBC", "001"}}), List{Effect::release_bcs});
    EXPECT_EQ(extra({{"Invn", "1"}}), List{Effect::normals_test});
    EXPECT_EQ(extra({{"Damp", "0.1"}}), List{Effect::tool_damping});
    EXPECT_EQ(extra({{"Dampr", "0.1"}}), List{Effect::tool_damping});
    EXPECT_EQ(extra({{"Inacti", "5"}}), List{Effect::initial_offset});
    EXPECT_EQ(extra({{"Inacti", "6"}}), List{Effect::initial_offset});
    EXPECT_EQ(extra({{"Inacti", "1"}}), List{});
    EXPECT_EQ(extra({{"Tstart", "0.1"}}), List{Effect::activity_window});
    EXPECT_EQ(extra({{"Tstop", "0.1"}}), List{Effect::activity_window});
    Model model = blank_over_tool();
    model.sensors.push_back({3, ""});
    EXPECT_EQ(extra({{"sens_ID", "3"}}, model), List{Effect::activity_window});
    model.as_built.set(Departure::D09);
    EXPECT_EQ(extra({{"sens_ID", "3"}}, model), List{}) << "D09: the sensor is ignored";
}

TEST(Plan, FilterAndSkidLineNeedFriction) {
    const Fields filter{{"Ifiltr", "1"}, {"Xfreq", "0.5"}, {"Pskid", "9.0"}};
    EXPECT_EQ(effects(filter).size(), 2u) << "there is no friction";
    Fields with_friction = filter;
    with_friction["Fric"] = "0.1";
    EXPECT_EQ(effects(with_friction),
              (List{Effect::elastic, Effect::damping, Effect::friction, Effect::friction_filter, Effect::skid_line}));
    with_friction["Xfreq"] = "0.0";
    with_friction["Pskid"] = "1e30";
    EXPECT_EQ(effects(with_friction), (List{Effect::elastic, Effect::damping, Effect::friction}));
}

TEST(Plan, HeatIsThereOnlyWithIthe) {
    const Model hot = thermal_blank_over_tool();
    EXPECT_EQ(effects({}, hot), (List{Effect::elastic, Effect::damping})) << "a thermal material asks for nothing";
    EXPECT_EQ(effects({{"Ithe", "1"}, {"Kthe", "20.0"}, {"Tint", "900.0"}}, hot),
              (List{Effect::elastic, Effect::damping, Effect::heat}));
    EXPECT_EQ(effects({{"Ithe", "1"}, {"Kthe", "20.0"}, {"Tint", "900.0"}, {"fct_IDF", "3"}}, hot),
              (List{Effect::elastic, Effect::damping, Effect::friction, Effect::friction_heat_factor, Effect::heat}));
    EXPECT_EQ(effects({{"Ithe", "1"}, {"Kthe", "20.0"}, {"Tint", "900.0"}, {"fct_IDF", "3"}, {"Ifric", "1"}}, hot),
              (List{Effect::elastic, Effect::damping, Effect::friction, Effect::heat}))
        << "fct_IDF scales Fric of law 0 only";
}

TEST(Plan, D28FiltersByTheCardWhereFrictionModelDoesNot) {
    Model model = blank_over_tool();
    model.friction_models.push_back({});
    model.friction_models[0].id = 9;
    model.friction_models[0].fallback.fric = 0.1;
    const Fields fields{{"fric_ID", "9"}, {"Ifiltr", "1"}, {"Xfreq", "0.5"}};
    EXPECT_EQ(effects(fields, model).back(), Effect::friction);
    model.as_built.set(Departure::D28);
    EXPECT_EQ(effects(fields, model).back(), Effect::friction_filter);
}

TEST(Plan, FrictionModelRubsByItsDefaultOrByAPair) {
    Model model = blank_over_tool();
    model.friction_models.push_back({});
    model.friction_models[0].id = 9;
    EXPECT_EQ(effects({{"fric_ID", "9"}, {"Fric", "0.3"}}, model).size(), 2u) << "the card's Fric is not used";
    FrictionPair pair;
    pair.coefficients.fric = 0.2;
    model.friction_models[0].pairs.push_back(pair);
    EXPECT_EQ(effects({{"fric_ID", "9"}}, model).back(), Effect::friction);
    model.friction_models[0].pairs.clear();
    model.friction_models[0].fallback.fric = 0.1;
    EXPECT_EQ(effects({{"fric_ID", "9"}}, model).back(), Effect::friction);
}

TEST(Plan, OneListForEachInterface) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({{"Fric", "0.1"}}) + card_text({{"Invn", "1"}}, "/INTER/TYPE21/2"), problems);
    const HostScene scene = plan(std::make_shared<const Model>(model));
    EXPECT_TRUE(scene.has(0, Effect::friction));
    EXPECT_FALSE(scene.has(0, Effect::normals_test));
    EXPECT_TRUE(scene.has(1, Effect::normals_test));
    EXPECT_FALSE(scene.has(1, Effect::friction));
    EXPECT_EQ(scene.model->interfaces.size(), 2u);
}

TEST(Plan, EffectsHaveNamesForPeople) {
    std::vector<std::string_view> names;
    for (int effect = 0; effect <= static_cast<int>(Effect::activity_window); ++effect) {
        const std::string_view one = name(static_cast<Effect>(effect));
        EXPECT_FALSE(one.empty());
        EXPECT_EQ(std::count(names.begin(), names.end(), one), 0) << one;
        names.push_back(one);
    }
}

}  // namespace
}  // namespace type21::test
