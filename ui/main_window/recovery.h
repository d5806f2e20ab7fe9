// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/session.h"
#include "ui/services/autosave.h"

#include <QObject>

#include <functional>

namespace cad2slam {

class MessageBar;

/// Keeps the journal of this run and offers what a run that crashed has left behind.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// `may_replace`: asks what is to become of unsaved changes before another project takes their place.
  Recovery(Session& session, MessageBar& messages, std::function<bool()> may_replace, QObject* parent = nullptr);

  /// Shows an offer for each journal of a dead program; whether there is any.
  bool offer();
  void recover(const Recoverable& recoverable);
  [[nodiscard]] Autosave& autosave() { return autosave_; }

 private:
  Session& session_;
  MessageBar& messages_;
  std::function<bool()> may_replace_;
  Autosave autosave_;
};

}  // namespace cad2slam
