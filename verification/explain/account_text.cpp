/// @file The account as aligned plain text.
#include <algorithm>

#include <fmt/format.h>

#include "verification/explain/explain_deck.h"

namespace type21 {
namespace {

constexpr size_t most_rejected = 12;    ///< segments shown one by one
constexpr size_t most_expression = 62;  ///< the value of a wider one is on the next line

/// "1 segment", "12 segments"
std::string counted(size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string expression(const AccountLine& line) {
    std::string out = line.formula;
    if (!line.numbers.empty()) out += (out.empty() ? "" : " = ") + line.numbers;
    return out;
}

std::string value_text(const AccountLine& line) {
    std::string out;
    if (const double* number = std::get_if<double>(&line.value)) out = digits(*number);
    if (const Vec3* vector = std::get_if<Vec3>(&line.value)) out = digits(*vector);
    if (!out.empty() && !line.unit.empty()) out += " " + line.unit;
    return out;
}

/// Symbol, expression, value with unit, source: each in its column.
std::string section_text(const AccountSection& section) {
    size_t symbol = 6;
    size_t wide = 0;
    size_t value = 0;
    for (const AccountLine& line : section.lines) {
        symbol = std::max(symbol, line.symbol.size());
        if (std::holds_alternative<std::string>(line.value)) continue;
        if (expression(line).size() <= most_expression) wide = std::max(wide, expression(line).size());
        value = std::max(value, value_text(line).size());
    }
    std::string out = section.title + "\n";
    for (const AccountLine& line : section.lines) {
        if (const std::string* words = std::get_if<std::string>(&line.value)) {
            out += fmt::format("  {:<{}}  {}{}\n", line.symbol, symbol, *words,
                               line.source.empty() ? "" : fmt::format("   [{}]", line.source));
            continue;
        }
        const std::string how = expression(line);
        if (how.size() > wide) {
            out += fmt::format("  {:<{}}  {}\n", line.symbol, symbol, how);
            out += fmt::format("  {:<{}}  {:<{}}  = {:<{}}  [{}]\n", "", symbol, "", wide, value_text(line), value,
                               line.source);
        } else {
            out += fmt::format("  {:<{}}  {:<{}}  = {:<{}}  [{}]\n", line.symbol, symbol, how, wide, value_text(line),
                               value, line.source);
        }
    }
    return out;
}

/// The last step of the projection that a sub-triangle of the segment reached.
int farthest_step(const SegmentAccount& segment) {
    int step = 0;
    for (const SubTriangleAccount& t : segment.triangles)
        step = std::max(step, t.step);
    return step;
}

std::string taken_text(const CandidateAccount& account) {
    std::string out;
    for (const SegmentAccount& segment : account.segments)
        for (const SubTriangleAccount& t : segment.triangles) {
            if (t.kind == Kind::none) continue;
            const bool retained =
                segment.segment == account.retained.segment && t.triangle == account.retained.triangle;
            out += fmt::format("  segment {:>6}  k={}  {:<9}  b = {:<10.6g} c = {:<10.6g} kappa = {:<12.9g} {}{}\n",
                               segment.segment + 1, t.triangle, t.kind == Kind::contact ? "contact" : "proximity",
                               t.numbers.weights->b, t.numbers.weights->c, t.kappa, t.reason,
                               retained ? "   <- retained" : "");
        }
    return out;
}

/// One line for the rejected sub-triangles of a segment.
std::string rejected_text(const SegmentAccount& segment) {
    std::string parts;
    for (const SubTriangleAccount& t : segment.triangles) {
        if (t.kind != Kind::none) continue;
        const std::string one = fmt::format("k={} step {}: {}", t.triangle, t.step, t.reason);
        parts += fmt::format("{}{:<34}", parts.empty() ? "" : " ", one);
    }
    if (parts.empty()) return "";
    parts.erase(parts.find_last_not_of(' ') + 1);
    return fmt::format("  segment {:>6}  {}\n", segment.segment + 1, parts);
}

std::string candidates_text(const CandidateAccount& account) {
    std::string out = fmt::format(
        "candidates: {} whose box contains the node; {} it, {} reject it (Formulation 3, steps 1 to 5)\n",
        counted(account.segments.size(), "segment", "segments"),
        counted(static_cast<size_t>(account.taken), "sub-triangle accepts", "sub-triangles accept"), account.rejected);
    out += taken_text(account);
    std::vector<const SegmentAccount*> order;
    for (const SegmentAccount& segment : account.segments)
        order.push_back(&segment);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto* a, const auto* b) { return farthest_step(*a) > farthest_step(*b); });
    size_t shown = 0;
    std::array<int, 6> left{};
    for (const SegmentAccount* segment : order) {
        const std::string text = rejected_text(*segment);
        if (text.empty()) continue;
        if (shown < most_rejected) {
            out += text;
            ++shown;
            continue;
        }
        for (const SubTriangleAccount& t : segment->triangles)
            if (t.kind == Kind::none) ++left[static_cast<size_t>(t.step)];
    }
    std::string rest;
    for (size_t step = 1; step < left.size(); ++step)
        if (left[step] > 0) rest += fmt::format("{}{} at step {}", rest.empty() ? "" : ", ", left[step], step);
    if (!rest.empty()) out += fmt::format("  the other segments: rejected {} (--json lists each)\n", rest);
    return out;
}

}  // namespace

std::string account_text(const DeckAccount& account, const Model& model) {
    const std::string time = model.units.name(dim::time);
    std::string out = fmt::format(
        "node {} at t = {:.9g} {}, cycle {}, dt = {:.6g} {} (requested t = {:.9g}); as built: {}\n", account.node,
        account.time, time, account.cycle, account.step, time, account.asked, model.as_built.text());
    for (const NodeAccount& of : account.interfaces) {
        out += fmt::format("\ninterface {} '{}'\n", of.interface, of.interface_title);
        out += section_text(of.place);
        if (of.active) out += candidates_text(of.candidates);
        for (const AccountSection& section : of.sections)
            out += section_text(section);
    }
    return out;
}

}  // namespace type21
