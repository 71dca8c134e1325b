#include "reasons/file_reason.h"

#include "disk/written_file.h"

namespace mapwright::reasons {

using map::ReasonCode;

map::Reason causeOf(const disk::Fault& fault) {
  switch (fault.code) {
    case disk::FaultCode::System:
      break;
    case disk::FaultCode::IsAFolder:
      return ReasonCode::IsAFolder;
    case disk::FaultCode::IsADisk:
      return ReasonCode::IsADisk;
    case disk::FaultCode::IsASocket:
      return ReasonCode::IsASocket;
    case disk::FaultCode::NotRegular:
      return ReasonCode::NotARegularFile;
    case disk::FaultCode::NoFileInFolder:
      return {ReasonCode::NoFileInFolder, {fault.folder, fault.system}};
    case disk::FaultCode::NobodyReads:
      return ReasonCode::NobodyReadsPipe;
    case disk::FaultCode::NothingTaken:
      return ReasonCode::ReaderTakesNothing;
  }
  return map::said(fault.system);
}

map::Reason notWritten(const disk::Fault& fault) {
  if (disk::isStandardOutput(fault.path)) return {ReasonCode::OutputNotWritten, {}, {causeOf(fault)}};
  return {ReasonCode::FileNotWritten, {fault.path}, {causeOf(fault)}};
}

}  // namespace mapwright::reasons
