// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/guarded_yaml.h"

#include <sstream>

namespace cad2slam {
namespace {

constexpr int kDeepestNesting = 32;

tl::unexpected<Error> refused(const std::string& file_name, int line, const std::string& message) {
  return fail(ErrorCode::kMalformed, message, file_name + ":" + std::to_string(line));
}

}  // namespace

void GuardedYamlEvents::OnDocumentStart(const YAML::Mark& /*mark*/) {}

void GuardedYamlEvents::OnDocumentEnd() {}

void GuardedYamlEvents::OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) {
  onValue(mark.line + 1, {});
}

void GuardedYamlEvents::OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) {
  throw YamlRefusal{mark.line + 1, "aliases (*name) are not read"};
}

void GuardedYamlEvents::OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                                 const std::string& value) {
  onValue(mark.line + 1, value);
}

void GuardedYamlEvents::OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                                        YAML::EmitterStyle::value /*style*/) {
  open(mark, false);
}

void GuardedYamlEvents::OnSequenceEnd() {
  close();
}

void GuardedYamlEvents::OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                                   YAML::EmitterStyle::value /*style*/) {
  open(mark, true);
}

void GuardedYamlEvents::OnMapEnd() {
  close();
}

void GuardedYamlEvents::open(const YAML::Mark& mark, bool is_map) {
  onOpen(mark.line + 1, is_map);
  if (depth_ >= kDeepestNesting) throw YamlRefusal{mark.line + 1, "the values are nested too deeply"};
  ++depth_;
}

void GuardedYamlEvents::close() {
  --depth_;
  onClose();
}

Result<void> readYamlEvents(const std::string& text, const std::string& file_name, GuardedYamlEvents& events) {
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(events);
  } catch (const YamlRefusal& refusal) {
    return refused(file_name, refusal.line, refusal.message);
  } catch (const YAML::Exception& error) {
    return refused(file_name, error.mark.line + 1, "is not valid YAML (" + error.msg + ")");
  }
  return {};
}

Result<YAML::Node> loadYaml(const std::string& text, const std::string& file_name) {
  GuardedYamlEvents guard;
  if (const Result<void> harmless = readYamlEvents(text, file_name, guard); !harmless) return failAs(harmless);
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    return refused(file_name, error.mark.line + 1, "is not valid YAML (" + error.msg + ")");
  }
}

}  // namespace cad2slam
