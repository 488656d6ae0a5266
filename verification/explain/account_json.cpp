#include "verification/explain/account_json.h"

namespace type21 {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json section_json(const AccountSection& section) {
    Json lines = Json::array();
    for (const AccountLine& line : section.lines) {
        Json one = Json::object();
        if (!line.symbol.empty()) one["symbol"] = line.symbol;
        if (!line.formula.empty()) one["formula"] = line.formula;
        if (!line.numbers.empty()) one["numbers"] = line.numbers;
        if (const double* number = std::get_if<double>(&line.value)) one["value"] = *number;
        if (const Vec3* vector = std::get_if<Vec3>(&line.value)) one["value"] = vector_json(*vector);
        if (const std::string* words = std::get_if<std::string>(&line.value)) one["value"] = *words;
        if (!line.unit.empty()) one["unit"] = line.unit;
        if (!line.source.empty()) one["source"] = line.source;
        lines.push_back(std::move(one));
    }
    return {{"title", section.title}, {"lines", std::move(lines)}};
}

const char* kind_name(Kind kind) {
    return kind == Kind::none ? "rejected" : kind == Kind::contact ? "contact" : "proximity";
}

Json triangle_json(const SubTriangleAccount& t) {
    const ProjectionRecord& r = t.numbers;
    Json json = {
        {"k", t.triangle}, {"kind", kind_name(t.kind)}, {"step", t.step}, {"reason", t.reason}, {"H", r.height}};
    if (r.corner_slopes) json["<n_V,N>"] = *r.corner_slopes;
    if (r.turn) json["<M,N>"] = *r.turn;
    if (r.lifted) json["b'"] = r.lifted->b, json["c'"] = r.lifted->c;
    if (r.slope) json["<n,N>"] = *r.slope;
    if (r.weights) json["b"] = r.weights->b, json["c"] = r.weights->c;
    if (t.side != 0) json["side"] = t.side, json["d"] = t.distance, json["kappa"] = t.kappa;
    return json;
}

Json candidates_json(const CandidateAccount& account) {
    Json segments = Json::array();
    for (const SegmentAccount& segment : account.segments) {
        Json triangles = Json::array();
        for (const SubTriangleAccount& t : segment.triangles)
            triangles.push_back(triangle_json(t));
        segments.push_back({{"segment", segment.segment + 1}, {"triangles", std::move(triangles)}});
    }
    return {{"taken", account.taken},
            {"rejected", account.rejected},
            {"why", account.why},
            {"segments", std::move(segments)}};
}

}  // namespace

Json account_json(const DeckAccount& account, const Model& model) {
    Json json = {{"deck", model.deck_path}, {"as_built", model.as_built.text()},
                 {"node", account.node},    {"time_asked", account.asked},
                 {"cycle", account.cycle},  {"time", account.time},
                 {"step", account.step},    {"interfaces", Json::array()}};
    for (const NodeAccount& of : account.interfaces) {
        Json sections = Json::array({section_json(of.place)});
        for (const AccountSection& section : of.sections)
            sections.push_back(section_json(section));
        json["interfaces"].push_back({{"interface", of.interface},
                                      {"active", of.active},
                                      {"candidates", candidates_json(of.candidates)},
                                      {"sections", std::move(sections)},
                                      {"force", vector_json(of.node.force)},
                                      {"replayed_to_the_last_bit", of.agrees}});
    }
    return json;
}

}  // namespace type21
