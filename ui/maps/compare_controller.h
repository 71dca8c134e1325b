// Compares the open map with another one.
#pragma once

#include <functional>
#include <memory>

#include <QByteArray>
#include <tl/expected.hpp>

#include "robot/robot.h"
#include "ui/kit/controller.h"
#include "ui/maps/picture_placing.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class CompareControl;

class CompareController : public Controller {
  Q_OBJECT
 public:
  /// `read`: returns a reader for the map at an address; the error is a sentence.
  using Read = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;

  CompareController(WindowContext& context, PicturePlacing& placing, Read read, QObject* parent = nullptr);
  ~CompareController() override;

  CompareControl* control() const { return control_; }
  void compareWith(const map::MapKey& key);
  /// Compares the edited map with the saved one; if that comparison is on, ends it.
  void compareWithSaved();
  void setSession(session::Session* session) override;
  bool escape() override;

 private:
  void chooseFile();
  void compareWithAddress(const QString& address);

  WindowContext& context_;
  PicturePlacing& placing_;
  Read read_;
  CompareControl* control_;
  std::unique_ptr<robot::Robot> source_;  // reads a file
};

}  // namespace mapwright::window
