#include "cli/running/stretch_crew.h"

#include "fuzz/campaign/parts/distribute.h"

namespace axiscert {

void run_stretches(const Plan& plan, const Stretches& stretches, const std::vector<std::uint64_t>& numbers,
                   const std::atomic<bool>& interrupted, const ShowProgress& show,
                   const std::function<void(const Entry&)>& done) {
  Crew crew(plan.running.threads, [&](Task task) { return encode(run_stretch(plan, stretches, task)); });
  Distributor distributor(crew, nullptr);
  ProgressCount count(show, numbers.size());
  auto next = numbers.begin();
  distributor.run({[&]() -> std::optional<Task> {
                     return next == numbers.end() || interrupted ? std::nullopt : std::optional<Task>(*next++);
                   },
                   [&] { return static_cast<std::uint64_t>(numbers.end() - next); },
                   [&](const TaskResult& result) {
                     const Entry entry = decode_entry(result.bytes);
                     done(entry);
                     count.finish_unit(stretches.at(entry.stretch).queries);
                   }});
}

}  // namespace axiscert
