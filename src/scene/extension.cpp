#include "scene/extension.hpp"

#include <algorithm>

#include "base/in_words.hpp"
#include "scene/check.hpp"
#include "scene/fixed_part.hpp"
#include "scene/located.hpp"

namespace reye::scene {

namespace {

const char* const only_these = "; it takes other limits and more cycles of its last step, nothing else";

struct Document {
  Node root;
  const std::string& text;
};

/// Every difference between two trees: values that differ, and the outermost entries that one of them lacks.
void add_differences(const Node& was, const Node& now, const Document& before, const Document& after, Issues& issues) {
  for (const auto& child : now.children)
    if (!was.find(child.name)) issues.push_back({child.key, child.written, "was not in the run to be resumed"});
  for (const auto& child : was.children) {
    const auto* other = now.find(child.name);
    if (!other)
      issues.push_back(
          {child.key, "",
           "is missing, and was " + (child.written.empty() ? "" : child.written + ' ') + "in the run to be resumed"});
    else if (is_branch(child) && is_branch(*other))
      add_differences(child, *other, before, after, issues);
    else if (value_of(child, before.text) != value_of(*other, after.text))
      issues.push_back({child.key, other->written, "was " + child.written + " in the run to be resumed"});
  }
}

bool counts(const Node& root, const std::string& cycles_key) {
  const auto* steps = root.find("step");
  const auto* cycles = steps && cycles_key == cycles_key_of(root) ? steps->children.back().find("cycles") : nullptr;
  return cycles && cycles->number > 0.0;
}

/// Limits that are new or have another bound; the scatter of wear does not count.
std::set<std::string> changed_limits(const Document& before, const Document& after) {
  std::set<std::string> names;
  const auto* were = before.root.find("limit");
  const auto* are = after.root.find("limit");
  if (!are) return names;
  for (const auto& limit : are->children) {
    const auto* was = were ? were->find(limit.name) : nullptr;
    Issues differences;
    if (was) add_differences(*was, limit, before, after, differences);
    std::erase_if(differences, [](const auto& issue) { return issue.key.ends_with(".wear_factor"); });
    if (!was || !differences.empty()) names.insert(limit.name);
  }
  return names;
}

/// Sorts out the differences that the continued run may have: they become its changes, others are wrong.
void sort_out(Issues differences, bool cycles_may, Extension& extension, Issues& wrong) {
  for (auto& issue : differences) {
    const bool may =
        issue.key == "limit" || issue.key.starts_with("limit.") || (cycles_may && issue.key == extension.cycles_key);
    if (may) {
      extension.changes.push_back(base::in_words(issue));
      continue;
    }
    issue.rule += only_these;
    wrong.push_back(std::move(issue));
  }
}

/// What is wrong with a scene that differs nowhere from the one before; empty: it continues it.
Issues not_continued(const Document& before, const Document& after, const std::string& was_fixed, const Written& now) {
  if (fixed_part(before.root, before.text) != fixed_part(after.root, after.text))
    return {{"", "", std::string("tables stand in a different order than in the run to be resumed") + only_these}};
  if (was_fixed != now.fixed_sha256)
    return {{"geometry", "",
             std::string("its files, or those of profiles, differ from those of the run to be resumed") + only_these}};
  if (now.accuracy > 0.0)
    return {{"accuracy", shown(now.accuracy),
             "chose elements and jumps for the run as it was; write the sizes that its plan reports as "
             "`size_mm`, and `jump`, in its place, and start a new run"}};
  return {};
}

}  // namespace

Extension extension_of(const std::string& was, const std::string& was_fixed, const Written& now) {
  const Document before{parse(was), was}, after{parse(now.text), now.text};
  Extension extension{{}, changed_limits(before, after), cycles_key_of(after.root)};
  const bool cycles_may = counts(before.root, extension.cycles_key) && counts(after.root, extension.cycles_key);
  Issues differences, wrong;
  add_differences(before.root, after.root, before, after, differences);
  sort_out(std::move(differences), cycles_may, extension, wrong);
  if (wrong.empty()) wrong = not_continued(before, after, was_fixed, now);
  if (!wrong.empty()) throw located(std::move(wrong), now.lines, now.path);
  return extension;
}

Extension extension_of(const std::string& was, const std::string& was_fixed, const Scene& now) {
  return extension_of(was, was_fixed, Written{now.text, now.fixed_sha256, now.path, now.lines, now.accuracy});
}

}  // namespace reye::scene
