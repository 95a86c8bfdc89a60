#include "engine/learning/comparison_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace trocar::learning {
namespace {

std::string cell_of(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string drawn(const Model& model, double value) {
  return is_sampled(model.options.method) ? cell_of(value) : "";
}

class Rows {
 public:
  void add(std::string_view name, const std::string& a, const std::string& b) {
    text_ += fmt::format("{},{},{}\n", name, a, b);
  }
  void add(std::string_view name, double a, double b) { add(name, cell_of(a), cell_of(b)); }
  std::string text() const { return text_; }

 private:
  std::string text_ = "measure,a,b\n";
};

}  // namespace

std::string comparison_csv(const Model& a, const Model& b, const ModelComparison& comparison) {
  const ModelMeasures& of_a = comparison.a;
  const ModelMeasures& of_b = comparison.b;
  Rows rows;
  rows.add("method", std::string(to_string(a.options.method)), std::string(to_string(b.options.method)));
  rows.add("epsilon", drawn(a, a.options.epsilon), drawn(b, b.options.epsilon));
  rows.add("seed", drawn(a, static_cast<double>(a.options.seed)), drawn(b, static_cast<double>(b.options.seed)));
  rows.add("fully_explored", drawn(a, of_a.exploration.fully_explored), drawn(b, of_b.exploration.fully_explored));
  rows.add("partly_explored", drawn(a, of_a.exploration.partly_explored), drawn(b, of_b.exploration.partly_explored));
  rows.add("fully_unexplored", drawn(a, of_a.exploration.fully_unexplored),
           drawn(b, of_b.exploration.fully_unexplored));
  rows.add("mean_reward", of_a.mean_reward, of_b.mean_reward);
  rows.add("least_reward", of_a.least_reward, of_b.least_reward);
  rows.add("mean_margin", of_a.mean_margin, of_b.mean_margin);
  rows.add("mismatch", of_a.mismatch, of_b.mismatch);
  rows.add("starts", of_a.all.count, of_b.all.count);
  rows.add("arrived", of_a.all.arrived, of_b.all.arrived);
  for (std::size_t k = 0; k < of_a.around.size(); ++k) {
    rows.add(fmt::format("starts_within_{}", k + 1), of_a.around[k].count, of_b.around[k].count);
    rows.add(fmt::format("arrived_within_{}", k + 1), of_a.around[k].arrived, of_b.around[k].arrived);
    rows.add(fmt::format("from_above_within_{}", k + 1), of_a.around[k].from_above, of_b.around[k].from_above);
  }
  return rows.text();
}

}  // namespace trocar::learning
