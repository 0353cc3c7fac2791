// The procedure of a study: read from a pack, kept in the study's protocol, found again there.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "app/session/study_protocol.h"
#include "core/base/error.h"
#include "core/procedure/procedure.h"
#include "core/store/study_file.h"

namespace tactus::session {

using ProcedurePtr = std::shared_ptr<const procedure::Procedure>;

/// The procedure `name`: one that the program carries, or the pack in a folder. Refused: an unknown name, and what
/// procedure::readPackFolder, questionnaires::checkWordings and the settings of a session refuse.
base::Result<ProcedurePtr> readPack(const std::string& name);
/// The same for the files of a pack that came in another way; `name` is the pack's name in errors.
base::Result<ProcedurePtr> readPack(procedure::PackFiles files, const std::string& name);

/// The protocol of a new study of `procedure`: the words of its inputs and of its force, its first form, its settings,
/// its languages. Consent and contact are the researcher's, so it is no complete protocol yet.
base::Result<StudyProtocol> firstProtocol(const ProcedurePtr& procedure);

/// Keeps the whole pack in `file`, a study without a protocol, with `firstProtocol` as its first draft.
base::Result<void> keepProcedure(store::StudyFile& file, const ProcedurePtr& procedure, SessionTools& tools);

/// The procedure that the study keeps; null if it keeps none, which is the default one. Refused: a pack that is not the
/// one of its SHA-256.
base::Result<ProcedurePtr> procedureIn(const store::StudyFile& file);

/// The same of the study at `path`; null also if there is none yet.
base::Result<ProcedurePtr> procedureAt(const std::string& path);

/// The protocol in `record` of `file`, with the procedure of the study.
base::Result<StudyProtocol> protocolOf(const store::StudyFile& file, const study::ProtocolRecord& record);

/// The settings of a session of `file`, with the procedure of the study.
base::Result<SessionSettings> settingsOf(const store::StudyFile& file, const study::SessionRecord& session);

/// Refuses with one sentence two studies of different procedures.
base::Result<void> requireSameProcedure(const store::StudyFile& one, const std::string& other);

}  // namespace tactus::session
