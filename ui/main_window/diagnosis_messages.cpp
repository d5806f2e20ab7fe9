// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/diagnosis_messages.h"

#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/view_pair.h"
#include "ui/models/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cad2slam {

using Kind = Finding::Kind;

namespace {

/// The first few; the rest are only hinted at.
QString namesOf(const std::vector<AnchorId>& anchors) {
  constexpr std::size_t kMost = 6;
  QStringList names;
  for (std::size_t i = 0; i < std::min(anchors.size(), kMost); ++i) names << QString::number(anchors[i]);
  if (anchors.size() > kMost) names << QStringLiteral("...");
  return names.join(QStringLiteral(", "));
}

}  // namespace

struct DiagnosisMessages::Request {
  std::uint64_t revision = 0;
  DiagnosisInput input;
  std::shared_ptr<GroundProbe> in_blueprint;  // only this worker uses them; null while a picture is being read
  std::shared_ptr<GroundProbe> in_slam;
  SolveResultPtr result;  // keeps alive what the input points to
  std::shared_ptr<const OccupancyGrid> blueprint;
  std::shared_ptr<const OccupancyGrid> rooms_of;
  std::shared_ptr<const RoomMap> rooms;
};

struct DiagnosisMessages::Answer {
  std::uint64_t revision = 0;
  std::vector<Finding> findings;
  std::shared_ptr<const OccupancyGrid> rooms_of;
  std::shared_ptr<const RoomMap> rooms;
};

DiagnosisMessages::DiagnosisMessages(Session& session, ViewPair& views, MessageBar& messages, QObject* parent)
    : QObject(parent), session_(session), views_(views), messages_(messages) {
  job_ = std::make_unique<LatestJob<Request, Answer>>(
      [](const Request& request) {
        Answer answer{request.revision, {}, request.rooms_of, request.rooms};
        if (answer.rooms_of != request.blueprint) {
          answer.rooms_of = request.blueprint;
          answer.rooms =
              request.blueprint ? std::make_shared<const RoomMap>(RoomMap::find(*request.blueprint)) : nullptr;
        }
        DiagnosisInput input = request.input;
        input.rooms = answer.rooms.get();
        for (const Anchor& anchor : input.anchors) {
          if (request.in_blueprint) input.ground_in_blueprint.push_back(request.in_blueprint->at(anchor.in_blueprint));
          if (request.in_slam) input.ground_in_slam.push_back(request.in_slam->at(anchor.in_slam));
        }
        answer.findings = diagnose(input);
        return answer;
      },
      [this](const Answer& answer) { take(answer); });
  connect(&session_.alignment(), &Alignment::statusChanged, this, &DiagnosisMessages::ask);
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kPreferences) ask();  // other limits judge the same solution
  });
}

DiagnosisMessages::~DiagnosisMessages() = default;

std::shared_ptr<GroundProbe> DiagnosisMessages::probeOf(Side side) {
  const std::shared_ptr<TilePyramid>& picture = session_.rasters().picture(side);
  const std::optional<MapFrame>& frame = session_.rasters().frame(side);
  if (!picture || !frame) return nullptr;
  if (picture->state() != TilePyramid::State::kReady) {
    connect(picture.get(), &TilePyramid::ready, this, &DiagnosisMessages::ask, Qt::UniqueConnection);
    return nullptr;
  }
  std::shared_ptr<GroundProbe>& probe = side == Side::kBlueprint ? in_blueprint_ : in_slam_;
  if (!probe || !probe->isOf(picture->store(), *frame)) {
    const ProjectDocument& document = session_.document();
    const ProjectSlamMap* map = document.currentMap();
    if (side == Side::kSlam && !map) return nullptr;
    probe = std::make_shared<GroundProbe>(
        picture->store(), *frame,
        side == Side::kBlueprint ? document.project().blueprint.metadata : map->raster.metadata);
  }
  return probe;
}

void DiagnosisMessages::ask() {
  ProjectDocument& document = session_.document();
  const AlignmentStatus status = session_.alignment().status();
  if (status == AlignmentStatus::kSolving) return;  // its end asks again
  if (!session_.isReady() || status == AlignmentStatus::kNotReady || status == AlignmentStatus::kNoAnchors) {
    job_->cancel();
    findings_.clear();
    messages_.showGroup(QStringLiteral("diagnosis-"), {});
    emit diagnosed();
    return;
  }
  const MapFrame& blueprint = *session_.rasters().frame(Side::kBlueprint);
  Request request;
  request.revision = document.revision();
  request.input.anchors = document.anchors();
  request.input.limits = document.state().limits;
  request.input.slam_m_per_px = session_.rasters().frame(Side::kSlam)->resolution();
  request.input.blueprint_m_per_px = blueprint.resolution();
  request.input.blueprint_diagonal_m = blueprint.diagonal();
  request.input.scale = document.project().settings.scale;
  if (request.input.scale.rule == ScaleRule::kToScale)  // nobody else asks what they say
    for (const ProjectSlamMap& map : document.project().slam_maps)
      if (map.name != document.currentMapName()) request.input.others.emplace_back(map.name, map.anchors);
  if (session_.alignment().isCurrent()) {
    request.result = session_.alignment().result();
    request.input.solution = &request.result->solution;
    request.input.projector = &request.result->projector;
    request.input.nodes = &request.result->mesh->centers();
  }
  request.in_blueprint = probeOf(Side::kBlueprint);
  request.in_slam = probeOf(Side::kSlam);
  request.blueprint = session_.rasters().grid(Side::kBlueprint);
  request.rooms_of = rooms_of_;
  request.rooms = rooms_;
  job_->request(std::move(request));
}

void DiagnosisMessages::take(const Answer& answer) {
  rooms_of_ = answer.rooms_of;
  rooms_ = answer.rooms;
  if (answer.revision != session_.document().revision()) return;
  findings_ = answer.findings;
  std::vector<Message> messages;
  for (const Finding& finding : findings_) messages.push_back(messageOf(finding));
  messages_.showGroup(QStringLiteral("diagnosis-"), std::move(messages));
  emit diagnosed();
}

QStringList DiagnosisMessages::sentences(Severity least) {
  QStringList texts;
  for (const Finding& finding : findings_)
    if (const Message message = messageOf(finding); message.severity >= least) texts += message.text;
  return texts;
}

Cure DiagnosisMessages::showCure(const Finding& finding) {
  return {tr("Show"), [this, ids = finding.anchors, place = finding.place] {
            if (!ids.empty()) {
              session_.selection().set(ids);
              views_.centerOn(ids.front());
            } else if (place) {
              views_.centerOnPlace(Side::kBlueprint, toQPointF(*place));
            }
          }};
}

Cure DiagnosisMessages::placeCure(const Finding& finding) {
  return {tr("Show a good place"), [this, place = finding.place] {
            if (place) views_.centerOnPlace(Side::kBlueprint, toQPointF(*place));
          }};
}

Cure DiagnosisMessages::rescaleCure(double factor) {
  return {tr("Rescale blueprint"), [this, factor] { edit::rescaleBlueprint(session_.document(), factor); }};
}

Message DiagnosisMessages::messageOf(const Finding& finding) {
  ProjectDocument& document = session_.document();
  Message message;
  message.severity = Severity::kWarning;
  message.id = QStringLiteral("diagnosis-%1").arg(static_cast<int>(finding.kind));
  if (finding.side == Side::kSlam) message.id += QStringLiteral("-slam");
  for (const AnchorId id : finding.anchors) message.id += QStringLiteral("-%1").arg(id);
  const AnchorId first = finding.anchors.empty() ? 0 : finding.anchors.front();
  const AnchorId second = finding.anchors.empty() ? 0 : finding.anchors.back();
  const int count = static_cast<int>(finding.anchors.size());
  const auto disable = [&](AnchorId id) {
    return Cure{tr("Disable %1").arg(id), [&document, id] { edit::setEnabled(document, {id}, false); }};
  };
  const auto percent = [](double ratio) { return numberText(100.0 * std::abs(ratio - 1.0), 1); };
  // Lengths that are compared are told in the same unit.
  const auto metres = [](double value_m) { return tr("%1 m").arg(numberText(value_m, 2)); };
  switch (finding.kind) {
    case Kind::kDuplicate: {
      const bool on_map = finding.value != finding.other;  // together in the blueprint, apart on the map
      message.severity = Severity::kError;
      message.text = (on_map ? tr("Anchors %1 and %2 share a blueprint point but are %3 apart on the SLAM map")
                             : tr("Anchors %1 and %2 share a point of the SLAM map but are %3 apart in the blueprint"))
                         .arg(first)
                         .arg(second)
                         .arg(lengthText(finding.value));
      message.cures = {showCure(finding), disable(second)};
      break;
    }
    case Kind::kMirrored:
      message.severity = Severity::kError;
      message.text = tr("The blueprint looks mirrored: mirrored, the anchors would be off by %1 instead of %2")
                         .arg(metres(finding.other), metres(finding.value));
      message.cures = {{tr("Mirror blueprint"), [this] {
                          if (const auto& frame = session_.rasters().frame(Side::kBlueprint))
                            edit::flipBlueprint(session_.document(), *frame);
                        }}};
      break;
    case Kind::kSwapped:
      message.severity = Severity::kError;
      message.text = tr("Anchors %1 and %2 look swapped: exchanged, the error falls from %3 to %4")
                         .arg(first)
                         .arg(second)
                         .arg(metres(finding.value), metres(finding.other));
      message.cures = {showCure(finding), {tr("Swap %1 and %2").arg(first).arg(second), [&document, first, second] {
                                             edit::swapCounterparts(document, first, second);
                                           }}};
      break;
    case Kind::kOutlier:
      message.text =
          tr("Anchor %1 does not fit the others: they put it %2 away").arg(first).arg(lengthText(finding.value));
      message.cures = {showCure(finding), disable(first)};
      break;
    case Kind::kUnpredicted:
      message.text = tr("The anchors do not predict each other: without itself, one is typically %1 off. Some are "
                        "misplaced, or more are needed between them")
                         .arg(lengthText(finding.value));
      if (finding.place) message.cures = {placeCure(finding)};
      break;
    case Kind::kHalfTurn:
      message.text =
          tr("After half a turn the anchors would fit as well: make sure that the SLAM map is the right way "
             "round, and add an anchor that has none opposite");
      break;
    case Kind::kFolded:
      message.text =
          finding.anchors.size() == 2
              ? tr("The mesh folds near anchors %1 and %2: they pull against each other").arg(first).arg(second)
              : tr("The mesh folds over itself: some anchors pull against each other");
      message.cures = {showCure(finding)};
      break;
    case Kind::kScale:
      message.severity = std::abs(finding.value - 1.0) > 0.1 ? Severity::kError : Severity::kWarning;
      if (!finding.agrees.empty()) {
        message.severity = Severity::kWarning;
        message.text = (finding.value > 1.0 ? tr("This SLAM map is %1 % too large: %2 agrees with the blueprint")
                                            : tr("This SLAM map is %1 % too small: %2 agrees with the blueprint"))
                           .arg(percent(finding.value), toQString(finding.agrees));
        break;
      }
      message.text = finding.value > 1.0 ? tr("The blueprint is %1 % too small for the SLAM map: its scale is wrong")
                                               .arg(percent(1.0 / finding.value))
                                         : tr("The blueprint is %1 % too large for the SLAM map: its scale is wrong")
                                               .arg(percent(1.0 / finding.value));
      message.cures = {rescaleCure(finding.value)};
      break;
    case Kind::kLengths: {
      const double ratio = finding.other / finding.value;
      const double off = std::abs(ratio - 1.0);
      const bool wrong = off > kScaleTolerance;
      message.severity = off > 0.1 ? Severity::kError : wrong ? Severity::kWarning : Severity::kNote;
      if (wrong && !finding.agrees.empty()) {
        message.severity = Severity::kWarning;
        message.text = tr("Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %), but %4 agrees with the "
                          "blueprint: check the two anchors, or this SLAM map is not to scale")
                           .arg(numberText(finding.value, 2), numberText(finding.other, 2), percent(ratio),
                                toQString(finding.agrees));
        break;
      }
      message.text =
          (wrong ? tr("Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): check the scale of the blueprint")
                 : tr("Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): the scale of the blueprint fits"))
              .arg(numberText(finding.value, 2), numberText(finding.other, 2), percent(ratio));
      if (wrong) message.cures = {rescaleCure(ratio)};
      break;
    }
    case Kind::kClose:
      message.text = tr("Anchors %1 and %2 are only %3 apart: add one far away, or the rotation stays a guess")
                         .arg(first)
                         .arg(second)
                         .arg(lengthText(finding.value));
      if (finding.place) message.cures = {placeCure(finding)};
      break;
    case Kind::kCollinear:
      message.text = tr("All anchors lie on one line: add one beside it, or the other direction stays a guess");
      if (finding.place) message.cures = {placeCure(finding)};
      break;
    case Kind::kOneRoom:
      message.text = tr("All anchors are in one room: the rest of the building is a guess");
      message.cures = {placeCure(finding)};
      break;
    case Kind::kEmptyRooms:
      message.severity = Severity::kNote;
      message.text = tr("%1 of %2 rooms have no anchor yet").arg(finding.value).arg(finding.other);
      message.cures = {showCure(finding)};
      break;
    case Kind::kOutsideImage:
      message.text = (finding.side == Side::kBlueprint ? tr("%n anchor(s) lie beside the blueprint: %1", nullptr, count)
                                                       : tr("%n anchor(s) lie beside the SLAM map: %1", nullptr, count))
                         .arg(namesOf(finding.anchors));
      message.cures = {showCure(finding),
                       {tr("Disable"), [&document, ids = finding.anchors] { edit::setEnabled(document, ids, false); }}};
      break;
    case Kind::kUnknownGround:
      message.severity = Severity::kNote;
      message.text = (finding.side == Side::kBlueprint
                          ? tr("%n anchor(s) lie where the blueprint shows neither floor nor wall: %1", nullptr, count)
                          : tr("%n anchor(s) lie where the SLAM map shows neither floor nor wall: %1", nullptr, count))
                         .arg(namesOf(finding.anchors));
      message.cures = {showCure(finding)};
      break;
    case Kind::kSimilarityEnough:
      message.severity = Severity::kNote;
      message.text =
          tr("A plain turn, shift and scale is enough here (%1 off in the middle): this SLAM map is not bent")
              .arg(lengthText(finding.value));
      break;
  }
  return message;
}

}  // namespace cad2slam
