// A simulated robot that runs, and what its tests ask it over HTTP.
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "raw_robot.h"
#include "simulator/simulator.h"

/// A robot whose clock stands still; its poses come often, since tests wait for them.
inline mapwright::simulator::Options paused(double at_s = 0) {
  mapwright::simulator::Options options;
  options.paused = true;
  options.start_at_s = at_s;
  options.pose_hz = 50;
  return options;
}

class Running : public mapwright::simulator::Simulator {
 public:
  explicit Running(const mapwright::simulator::Options& options = paused()) : Simulator(options) {
    if (const auto problem = start()) qFatal("%s", problem->c_str());
  }
  raw::HttpReply get(const std::string& target, const std::map<std::string, std::string>& headers = {},
                     const std::string& method = "GET") const {
    return raw::get(port(), target, headers, method);
  }
  raw::HttpReply send(const std::string& method, const std::string& target, const std::string& body,
                      const std::map<std::string, std::string>& headers = {}) const {
    return raw::send(port(), method, target, body, headers);
  }
};

inline QJsonObject object(const std::string& json) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}
inline QJsonObject object(const QString& json) { return object(json.toStdString()); }
inline QJsonArray array(const std::string& json) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(json)).array();
}
