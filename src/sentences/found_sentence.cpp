#include "sentences/found_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "sentences/plural.h"
#include "words/listed.h"
#include "words/shortened.h"

namespace mapwright::sentences {
namespace {

class FoundText {
  Q_DECLARE_TR_FUNCTIONS(FoundRobot)
};

}  // namespace

QString foundCalled(const robot::FoundRobot& robot) {
  QStringList told;
  const QString& name = robot.identity.name.isEmpty() ? robot.identity.serial : robot.identity.name;
  for (const QString& one : {name, robot.identity.model, robot.identity.version}) {
    if (!one.trimmed().isEmpty()) told << words::shortened(one.trimmed(), 80);
  }
  if (robot.topics) {
    told << counted(FoundText::tr("%1 topics", nullptr, formOf(*robot.topics)), *robot.topics);
  }
  if (robot.services) {
    told << counted(FoundText::tr("%1 services", nullptr, formOf(*robot.services)), *robot.services);
  }
  if (robot.wants_secret) told << FoundText::tr("asks for a secret");
  return words::listed(told);
}

}  // namespace mapwright::sentences
