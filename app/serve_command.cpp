// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli_command.h"
#include "app/line_server.h"
#include "cad2slam/io/pose_protocol.h"
#include "cad2slam/io/projector_file.h"

namespace cad2slam::cli {
namespace {

struct ServeOptions {
  std::string projector;
  std::string socket;
};

void answerLine(const Projector& projector, std::string_view line, std::string& out) {
  std::string id;
  const Result<PoseRequest> request = parsePoseRequest(line, id);
  if (!request) return appendError(id, request.error(), out);
  if (request->kind == PoseRequest::Kind::kInfo) return appendInfo(*request, projector, out);
  const OutsidePolicy outside = request->outside.value_or(projector.info().outside);
  std::vector<Projection> answers(request->poses.size());
  if (request->kind == PoseRequest::Kind::kProject) {
    projector.slamFromBlueprint(request->poses.data(), answers.data(), answers.size(), outside);
  } else {
    projector.blueprintFromSlam(request->poses.data(), answers.data(), answers.size(), outside);
  }
  appendAnswer(*request, answers.data(), out);
}

Result<void> serve(const ServeOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const LineHandler handler = [&projector](std::string_view line, std::string& out) {
    const std::size_t before = out.size();
    try {
      answerLine(*projector, line, out);
    } catch (const std::bad_alloc&) {
      out.resize(before);
      appendError({}, {ErrorCode::kInternal, "there is not enough memory for the request", {}}, out);
    }
  };
  LineLimits limits;
  limits.too_long.clear();
  appendError({}, {ErrorCode::kMalformed, "the request is too long", {}}, limits.too_long);
  if (options.socket.empty()) return serveStandardInput(handler, limits);
  return serveUnixSocket(options.socket, handler, limits,
                         [&options] { std::cerr << "cad2slam-cli: listening on " << options.socket << '\n'; });
}

}  // namespace

void addServeCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* command = app.add_subcommand("serve", "Answer other processes: one JSON object a line in, one out");
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("--socket", options->socket, "Unix socket to listen on (default: standard input and output)");
  command->callback([options, &chosen] { chosen.set([options] { return serve(*options); }); });
}

}  // namespace cad2slam::cli
