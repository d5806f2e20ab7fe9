// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <string>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// Why a text is refused; thrown through the parser of yaml-cpp, which knows no other way out.
struct YamlRefusal {
  int line = 0;
  std::string message;
};

/// The events of one YAML document, without what makes a small file grow: aliases, which multiply what they name, and
/// deep nesting. Derived classes collect what they need; this one only looks.
class GuardedYamlEvents : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) final;
  void OnDocumentEnd() final;
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) final;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) final;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string& value) final;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) final;
  void OnSequenceEnd() final;
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) final;
  void OnMapEnd() final;

 protected:
  /// How many lists and maps are open around what comes.
  [[nodiscard]] int depth() const { return depth_; }
  virtual void onValue(int /*line*/, const std::string& /*value*/) {}
  virtual void onOpen(int /*line*/, bool /*is_map*/) {}
  virtual void onClose() {}

 private:
  void open(const YAML::Mark& mark, bool is_map);
  void close();

  int depth_ = 0;
};

/// Gives the first document of `text` to `events`. kMalformed, with file and line: no YAML, an alias, nested too
/// deeply, or what a derived class refuses.
[[nodiscard]] Result<void> readYamlEvents(const std::string& text, const std::string& file_name,
                                          GuardedYamlEvents& events);
/// The first document of `text` as a tree, which is no larger than the text lets expect.
[[nodiscard]] Result<YAML::Node> loadYaml(const std::string& text, const std::string& file_name);

}  // namespace cad2slam
