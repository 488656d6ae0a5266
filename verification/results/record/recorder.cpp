#include "verification/results/record/recorder.h"

#include "verification/results/record/run_id.h"

namespace type21 {
namespace {

template <class Column>
std::vector<std::string> header(std::vector<std::string> lead, const std::vector<Column>& columns) {
    for (const Column& column : columns)
        lead.push_back(column.name);
    return lead;
}

}  // namespace

Recorder::Recorder(const HostScene& scene, const std::filesystem::path& folder)
    : model_(*scene.host),
      clock_(model_.engine.history_interval),
      node_history_(node_history(model_)),
      body_history_(scene) {
    for (size_t i = 0; i < model_.interfaces.size(); ++i) {
        std::vector<InterfaceColumn> columns = chosen_columns(model_, static_cast<int>(i));
        CsvWriter file(folder / fmt::format("interface_{}.csv", model_.interfaces[i].id), header({"time"}, columns));
        interfaces_.push_back({std::move(file), std::move(columns)});
        effects_.emplace_back(scene, static_cast<int>(i), folder);
    }
    if (!node_history_.nodes.empty() && !node_history_.columns.empty())
        nodes_.emplace(folder / "nodes.csv", header({"time", "node"}, node_history_.columns));
    if (!body_history_.bodies().empty()) bodies_.emplace(folder / "rbody.csv", RigidBodyHistory::header());
}

void Recorder::observe(const CycleRecord& record) {
    body_history_.add(record);
    for (EffectFiles& files : effects_)
        files.observe(record);
    if (clock_.due(record.time, record.step, record.last)) write(record);
}

void Recorder::write(const CycleRecord& record) {
    const std::string time = digits17(record.time);
    std::vector<double> values;
    for (size_t i = 0; i < interfaces_.size(); ++i) {
        values.clear();
        for (const InterfaceColumn& column : interfaces_[i].columns)
            values.push_back(column.value((*record.totals)[i]));
        interfaces_[i].file.row(time, std::nullopt, values);
    }
    if (nodes_) write_nodes(record, time);
    if (bodies_) {
        for (size_t body = 0; body < body_history_.bodies().size(); ++body) {
            const auto index = static_cast<size_t>(body_history_.bodies()[body]);
            bodies_->row(time, model_.rigid_bodies[index].id, body_history_.values(record, body));
        }
    }
    if (Clock::now() - flushed_ > std::chrono::seconds(1)) flush();
}

void Recorder::write_nodes(const CycleRecord& record, const std::string& time) {
    std::vector<double> values;
    for (const int node : node_history_.nodes) {
        const auto index = static_cast<size_t>(node);
        values.clear();
        for (const NodeColumn& column : node_history_.columns)
            values.push_back(column.value(record, index));
        nodes_->row(time, model_.nodes.id[index], values);
    }
}

std::vector<CsvWriter*> Recorder::files() {
    std::vector<CsvWriter*> files;
    for (InterfaceFile& interface : interfaces_)
        files.push_back(&interface.file);
    for (std::optional<CsvWriter>* file : {&nodes_, &bodies_})
        if (*file) files.push_back(&**file);
    for (EffectFiles& effects : effects_)
        for (CsvWriter* file : effects.files())
            files.push_back(file);
    return files;
}

void Recorder::flush() {
    for (CsvWriter* file : files())
        file->flush();
    flushed_ = Clock::now();
}

std::vector<WrittenFile> Recorder::written() {
    std::vector<WrittenFile> written;
    for (const CsvWriter* file : files())
        written.push_back(file->written());
    return written;
}

void Recorder::close(std::string_view run_id) {
    for (CsvWriter* file : files())
        file->close(csv_mark(run_id));
}

}  // namespace type21
