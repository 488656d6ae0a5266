#include "driven_scene.h"

#include <fmt/format.h>

#include "reference/deck/deck.h"
#include "reference/model/resolve.h"

namespace type21::test {

std::string ints(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields)
        line += fmt::format("{:>10}", field);
    return line + "\n";
}

std::string reals(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields)
        line += fmt::format("{:>20}", field);
    return line + "\n";
}

namespace {

std::string node(const std::string& id, const std::vector<std::string>& position) {
    return fmt::format("{:>10}", id) + reals(position);
}

std::string mesh() {
    return "/NODE\n" + node("1", {"0.0", "0.0", "0.0"}) + node("2", {"10.0", "0.0", "0.0"}) +
           node("3", {"10.0", "10.0", "0.0"}) + node("4", {"0.0", "10.0", "0.0"}) + node("5", {"20.0", "0.0", "0.0"}) +
           node("101", {"-5.0", "-5.0", "2.0"}) + node("102", {"-5.0", "15.0", "2.0"}) +
           node("103", {"25.0", "15.0", "2.0"}) + node("104", {"25.0", "-5.0", "2.0"}) +
           node("201", {"5.0", "5.0", "10.0"}) + "/SHELL/1\n" + ints({"1", "1", "2", "3", "4"}) + "/SH3N/1\n" +
           ints({"2", "2", "5", "3"}) + "/SHELL/2\n" + ints({"3", "101", "102", "103", "104"});
}

std::string parts() {
    return "/MAT/ELAST/1\nsheet\n" + reals({"7.8e-09"}) + reals({"210000.0", "0.3"}) + "/MAT/VOID/2\ntool\n" +
           reals({"7.8e-09", "210000.0", "0.3"}) + "/PROP/SHELL/1\nsheet\n\n\n" +
           "         5                           1.5                                       1         1\n" +
           "/PROP/VOID/2\ntool\n" + reals({"1.0"}) + "/PART/1\nsheet\n" + ints({"1", "1"}) + "/PART/2\ntool\n" +
           ints({"2", "2"});
}

std::string sets() {
    return "/SURF/PART/1\nblank\n" + ints({"1"}) + "/SURF/PART/2\ntool\n" + ints({"2"}) + "/GRNOD/PART/1\nblank\n" +
           ints({"1"}) + "/GRNOD/PART/2\ntool\n" + ints({"2"}) + "/GRNOD/NODE/3\nmain node\n" + ints({"201"});
}

std::string motion() {
    return "/RBODY/7\ntool\n       201         0         0         0                0.02         2         0         "
           "4\n" +
           reals({"1000.0", "1000.0", "1000.0"}) + reals({"0.0", "0.0", "0.0"}) + "\n/BCS/1\nguide\n   110 111" +
           ints({"0", "3"}) + "/BCS/2\nblank\n   111 111" + ints({"0", "1"}) + "/FUNCT/1\nstroke\n" +
           reals({"0.0", "0.0"}) + reals({"1.0", "1.0"}) + "/IMPVEL/1\ndown\n" +
           ints({"1", "Z", "0", "0", "3", "0", "0"}) + reals({"1.0", "-1000.0", "0.0", "0.0"});
}

std::string interface() {
    return "/INTER/TYPE21/1\ncontact\n" + ints({"1", "2"}) + std::string(10, '\n') + ints({"7"});
}

}  // namespace

std::string driven_scene() {
    return "#RADIOSS STARTER\n/BEGIN\nscene\n" + ints({"2025", "0"}) + reals({"Mg", "mm", "s"}) +
           reals({"Mg", "mm", "s"}) + "/TITLE\na driven tool\n" + parts() + mesh() + sets() + motion() + interface() +
           "/END\n";
}

std::string driven_engine() {
    return "#RADIOSS ENGINE\n/VERS/2025\n/RUN/scene/1\n  0.001\n/DTIX\n  1e-6  1e-6\n";
}

std::string with_cards(const std::string& cards) {
    return replaced(driven_scene(), "/END\n", cards + "/END\n");
}

Resolved resolved(const std::string& starter, const std::string& engine) {
    const TempFolder folder;
    Resolved result;
    const std::string path = folder.write("scene_0000.rad", starter);
    if (!engine.empty()) folder.write("scene_0001.rad", engine);
    const Deck deck = read_deck(path, result.problems);
    result.model = resolve(deck, AsBuilt{}, result.problems);
    return result;
}

Problem only(const Problems& problems) {
    EXPECT_EQ(problems.list().size(), 1U) << all_of(problems);
    return problems.list().empty() ? Problem{} : problems.list().front();
}

}  // namespace type21::test
