// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/diagnosis.h"
#include "ui/main_window/session.h"
#include "ui/panels/message_bar.h"
#include "ui/services/ground_probe.h"
#include "ui/views/latest_job.h"

#include <QObject>

#include <memory>
#include <vector>

namespace cad2slam {

class ViewPair;

/// Looks for problems after every edit, on a thread of its own, and says them in words with buttons that cure them.
class DiagnosisMessages : public QObject {
  Q_OBJECT

 public:
  DiagnosisMessages(Session& session, ViewPair& views, MessageBar& messages, QObject* parent = nullptr);
  ~DiagnosisMessages() override;

  /// Of the last look; tests and the report read them.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// The same in words, closed messages too; those of this severity and above.
  [[nodiscard]] QStringList sentences(Severity least);

 signals:
  void diagnosed();

 private:
  struct Request;
  struct Answer;

  void ask();
  void take(const Answer& answer);
  [[nodiscard]] std::shared_ptr<GroundProbe> probeOf(Side side);
  [[nodiscard]] Message messageOf(const Finding& finding);
  [[nodiscard]] Cure showCure(const Finding& finding);
  [[nodiscard]] Cure placeCure(const Finding& finding);  // where an anchor is missing
  [[nodiscard]] Cure rescaleCure(double factor);

  Session& session_;
  ViewPair& views_;
  MessageBar& messages_;
  std::vector<Finding> findings_;
  std::shared_ptr<const OccupancyGrid> rooms_of_;
  std::shared_ptr<const RoomMap> rooms_;
  std::shared_ptr<GroundProbe> in_blueprint_;
  std::shared_ptr<GroundProbe> in_slam_;
  std::unique_ptr<LatestJob<Request, Answer>> job_;
};

}  // namespace cad2slam
