<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>CollectFeature</name>
    <message numerus="yes">
        <source>%n simulated nurse(s) were added. They are marked as simulated.</source>
        <translation>
            <numerusform>%n simulated nurse was added. It is marked as simulated.</numerusform>
            <numerusform>%n simulated nurses were added. They are marked as simulated.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n answer file(s) read, %1 with new answers. %2</source>
        <translation>
            <numerusform>%n answer file read, %1 with new answers. %2</numerusform>
            <numerusform>%n answer files read, %1 with new answers. %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CurveItems</name>
    <message numerus="yes">
        <source>%n expert(s)</source>
        <translation>
            <numerusform>%n expert</numerusform>
            <numerusform>%n experts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mean ± 1 standard deviation (n − 1) of the %n expert(s), where three or more have a rule. So few people say little about others; the range says what these said.</source>
        <translation>
            <numerusform>Mean ± 1 standard deviation (n − 1) of the %n expert, where three or more have a rule. So few people say little about others; the range says what these said.</numerusform>
            <numerusform>Mean ± 1 standard deviation (n − 1) of the %n experts, where three or more have a rule. So few people say little about others; the range says what these said.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message numerus="yes">
        <source>Exported %n participant(s) into %1. %2</source>
        <translation>
            <numerusform>Exported %n participant into %1. %2</numerusform>
            <numerusform>Exported %n participants into %1. %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FindingRowsText</name>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n hole</numerusform>
            <numerusform>%n holes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n jump(s) of the mean</source>
        <translation>
            <numerusform>%n jump of the mean</numerusform>
            <numerusform>%n jumps of the mean</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) of the force</source>
        <translation>
            <numerusform>%n step of the force</numerusform>
            <numerusform>%n steps of the force</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n region(s) without a rule</source>
        <translation>
            <numerusform>%n region without a rule</numerusform>
            <numerusform>%n regions without a rule</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n missing answer(s)</source>
        <translation>
            <numerusform>%n missing answer</numerusform>
            <numerusform>%n missing answers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n conflict(s)</source>
        <translation>
            <numerusform>%n conflict</numerusform>
            <numerusform>%n conflicts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>apart at %n place(s)</source>
        <translation>
            <numerusform>apart at %n place</numerusform>
            <numerusform>apart at %n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) against the declaration</source>
        <translation>
            <numerusform>%n step against the declaration</numerusform>
            <numerusform>%n steps against the declaration</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n jump(s)</source>
        <translation>
            <numerusform>%n jump</numerusform>
            <numerusform>%n jumps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) of direction</source>
        <translation>
            <numerusform>%n change of direction</numerusform>
            <numerusform>%n changes of direction</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n disagreement(s)</source>
        <translation>
            <numerusform>%n disagreement</numerusform>
            <numerusform>%n disagreements</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n redundant rule(s)</source>
        <translation>
            <numerusform>%n redundant rule</numerusform>
            <numerusform>%n redundant rules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s) that never fire</source>
        <translation>
            <numerusform>%n rule that never fires</numerusform>
            <numerusform>%n rules that never fire</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreachable term(s)</source>
        <translation>
            <numerusform>%n unreachable term</numerusform>
            <numerusform>%n unreachable terms</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unused term(s)</source>
        <translation>
            <numerusform>%n unused term</numerusform>
            <numerusform>%n unused terms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FindingWords</name>
    <message numerus="yes">
        <source> (rule(s) %1)</source>
        <translation>
            <numerusform> (rule %1)</numerusform>
            <numerusform> (rules %1)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> (item(s) %1)</source>
        <translation>
            <numerusform> (item %1)</numerusform>
            <numerusform> (items %1)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; no answer to item(s) %1</source>
        <translation>
            <numerusform>; no answer to item %1</numerusform>
            <numerusform>; no answer to items %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n connected</numerusform>
            <numerusform>%n connected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ModelInStudyText</name>
    <message numerus="yes">
        <source>%n expert(s)</source>
        <translation>
            <numerusform>%n expert</numerusform>
            <numerusform>%n experts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n note(s) about it beside the heading.</source>
        <translation>
            <numerusform>There is a note about it beside the heading.</numerusform>
            <numerusform>There are %n notes about it beside the heading.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OverviewText</name>
    <message numerus="yes">
        <source>%n nurse(s)</source>
        <translation>
            <numerusform>%n nurse</numerusform>
            <numerusform>%n nurses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n judgement(s) became the words for the force.</source>
        <translation>
            <numerusform>%n judgement became the words for the force.</numerusform>
            <numerusform>%n judgements became the words for the force.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n expert(s)</source>
        <translation>
            <numerusform>%n expert</numerusform>
            <numerusform>%n experts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OverviewView</name>
    <message numerus="yes">
        <source>and %n more, in its lab</source>
        <translation>
            <numerusform>and %n more, in its lab</numerusform>
            <numerusform>and %n more, in its lab</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PanelFeatures</name>
    <message numerus="yes">
        <source>Contracts (%n broken)</source>
        <translation>
            <numerusform>Contracts (%n broken)</numerusform>
            <numerusform>Contracts (%n broken)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlanChart</name>
    <message numerus="yes">
        <source>%n question(s)</source>
        <translation>
            <numerusform>%n question</numerusform>
            <numerusform>%n questions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PullText</name>
    <message numerus="yes">
        <source>These words belong to %n experts: the forces of all of them move.</source>
        <translation>
            <numerusform>These words belong to %n expert.</numerusform>
            <numerusform>These words belong to %n experts: the forces of all of them move.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RailFeature</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) changed</source>
        <translation>
            <numerusform>%n setting changed</numerusform>
            <numerusform>%n settings changed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReadinessText</name>
    <message numerus="yes">
        <source>No rule fires at %n place(s): add a rule there, or accept each by its name.</source>
        <translation>
            <numerusform>No rule fires at %n place: add a rule there, or accept it by its name.</numerusform>
            <numerusform>No rule fires at %n places: add a rule there, or accept each by its name.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n accepted place(s) no rule fires; the force there is %1.</source>
        <translation>
            <numerusform>At %n accepted place no rule fires; the force there is %1.</numerusform>
            <numerusform>At %n accepted places no rule fires; the force there is %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of rules have the same conditions and different forces.</source>
        <translation>
            <numerusform>%n pair of rules has the same conditions and different forces.</numerusform>
            <numerusform>%n pairs of rules have the same conditions and different forces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n place(s) two experts are more than two just-noticeable differences apart, by up to %1.</source>
        <translation>
            <numerusform>At %n place two experts are more than two just-noticeable differences apart, by up to %1.</numerusform>
            <numerusform>At %n places two experts are more than two just-noticeable differences apart, by up to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No expert has signed off the last %n edit(s).</source>
        <translation>
            <numerusform>No expert has signed off the last edit.</numerusform>
            <numerusform>No expert has signed off the last %n edits.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) to settle first</source>
        <translation>
            <numerusform>%n thing to settle first</numerusform>
            <numerusform>%n things to settle first</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>0 of %n expert(s) have approved this version.</source>
        <translation>
            <numerusform>0 of 1 expert have approved this version.</numerusform>
            <numerusform>0 of %n experts have approved this version.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n place(s) the force steps within 1 mm or faster than it can be rendered, by up to %1.</source>
        <translation>
            <numerusform>At %n place the force steps within 1 mm or faster than it can be rendered, by %1.</numerusform>
            <numerusform>At %n places the force steps within 1 mm or faster than it can be rendered, by up to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) of the build differ from the published ones (%1); as built, they move the force by up to %2.</source>
        <translation>
            <numerusform>%n setting of the build differs from the published one (%1); as built, it moves the force by up to %2.</numerusform>
            <numerusform>%n settings of the build differ from the published ones (%1); as built, they move the force by up to %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) of the build differ from the published ones (%1); by how much they move the force is not known.</source>
        <translation>
            <numerusform>%n setting of the build differs from the published one (%1); by how much it moves the force is not known.</numerusform>
            <numerusform>%n settings of the build differ from the published ones (%1); by how much they move the force is not known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) open; a bundle can be made</source>
        <translation>
            <numerusform>%n thing open; a bundle can be made</numerusform>
            <numerusform>%n things open; a bundle can be made</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) on the data and %1 of the build, first: %2</source>
        <translation>
            <numerusform>%n note on the data and %1 of the build: %2</numerusform>
            <numerusform>%n notes on the data and %1 of the build, first: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) of the build.</source>
        <translation>
            <numerusform>%n note of the build.</numerusform>
            <numerusform>%n notes of the build.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The model breaks %1 of %n contract(s), so a bundle of it fails its own check, first: %2.</source>
        <translation>
            <numerusform>The model breaks %1 of %n contract, so a bundle of it fails its own check, first: %2.</numerusform>
            <numerusform>The model breaks %1 of %n contracts, so a bundle of it fails its own check, first: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n contract(s), %1 could be neither proved nor refuted.</source>
        <translation>
            <numerusform>Of %n contract, %1 could be neither proved nor refuted.</numerusform>
            <numerusform>Of %n contracts, %1 could be neither proved nor refuted.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The model keeps %n contract(s) everywhere, proved.</source>
        <translation>
            <numerusform>The model keeps its contract everywhere, proved.</numerusform>
            <numerusform>The model keeps %n contracts everywhere, proved.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SealFeature</name>
    <message numerus="yes">
        <source>%n point(s) of %1 are under seal. Keep the passphrase, and the file away from all who answer or edit. SHA-256 %2</source>
        <translation>
            <numerusform>%n point of %1 is under seal. Keep the passphrase, and the file away from all who answer or edit. SHA-256 %2</numerusform>
            <numerusform>%n points of %1 are under seal. Keep the passphrase, and the file away from all who answer or edit. SHA-256 %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The reference is open: %n point(s), unchanged since it was sealed.</source>
        <translation>
            <numerusform>The reference is open: %n point, unchanged since it was sealed.</numerusform>
            <numerusform>The reference is open: %n points, unchanged since it was sealed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyContentsText</name>
    <message numerus="yes">
        <source>%n participant(s) who withdrew</source>
        <translation>
            <numerusform>a participant who withdrew</numerusform>
            <numerusform>%n participants who withdrew</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TermForms</name>
    <message numerus="yes">
        <source>Its %n rule(s) are copied to each part, so the force stays as it is until you change a part.</source>
        <translation>
            <numerusform>Its rule is copied to each part, so the force stays as it is until you change a part.</numerusform>
            <numerusform>Its %n rules are copied to each part, so the force stays as it is until you change a part.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove it and its %n rule(s)</source>
        <translation>
            <numerusform>Remove it and its rule</numerusform>
            <numerusform>Remove it and its %n rules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s) name this term and go with it. Undo brings all back.</source>
        <translation>
            <numerusform>One rule names this term and goes with it. Undo brings both back.</numerusform>
            <numerusform>%n rules name this term and go with it. Undo brings all back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::BundlePanel</name>
    <message numerus="yes">
        <source>Made and read back: %n file(s), each within its tolerance</source>
        <translation>
            <numerusform>Made and read back: %n file, each within its tolerance</numerusform>
            <numerusform>Made and read back: %n files, each within its tolerance</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Read: %n file(s), each within its tolerance</source>
        <translation>
            <numerusform>Read: %n file, each within its tolerance</numerusform>
            <numerusform>Read: %n files, each within its tolerance</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CarryDialog</name>
    <message numerus="yes">
        <source>%n edit(s) of “%1”, each tried alone on the open model. Those that you choose become one step, which Undo takes back.</source>
        <translation>
            <numerusform>%n edit of “%1”, tried on the open model. Chosen, it becomes one step, which Undo takes back.</numerusform>
            <numerusform>%n edits of “%1”, each tried alone on the open model. Those that you choose become one step, which Undo takes back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them put(s) something else in the place of what the new model has of its own; choose what counts.</source>
        <translation>
            <numerusform>%n of them puts something else in the place of what the new model has of its own; choose what counts.</numerusform>
            <numerusform>%n of them put something else in the place of what the new model has of its own; choose what counts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Carry over %n edit(s)</source>
        <translation>
            <numerusform>Carry over %n edit</numerusform>
            <numerusform>Carry over %n edits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ClusterPlot</name>
    <message numerus="yes">
        <source>▲ %n warning(s)</source>
        <translation>
            <numerusform>▲ %n warning</numerusform>
            <numerusform>▲ %n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareCard</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n term(s), rule(s) or setting(s) differ, %1 → %2:</source>
        <translation>
            <numerusform>%n term, rule or setting differs, %1 → %2:</numerusform>
            <numerusform>%n terms, rules or settings differ, %1 → %2:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareController</name>
    <message numerus="yes">
        <source>Open model, mean of %n expert(s)</source>
        <translation>
            <numerusform>Open model, mean of %n expert</numerusform>
            <numerusform>Open model, mean of %n experts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeliveredPlot</name>
    <message numerus="yes">
        <source>%n judgement(s)</source>
        <translation>
            <numerusform>%n judgement</numerusform>
            <numerusform>%n judgements</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n below 90 % of the force</source>
        <translation>
            <numerusform>%n below 90 % of the force</numerusform>
            <numerusform>%n below 90 % of the force</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not measured</source>
        <translation>
            <numerusform>%n not measured</numerusform>
            <numerusform>%n not measured</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthSettingsPanel</name>
    <message numerus="yes">
        <source>%n point(s), %1 mm from the entry to the end</source>
        <translation>
            <numerusform>%n point, %1 mm from the entry to the end</numerusform>
            <numerusform>%n points, %1 mm from the entry to the end</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeviceBar</name>
    <message numerus="yes">
        <source>%n tick(s)</source>
        <translation>
            <numerusform>%n tick</numerusform>
            <numerusform>%n ticks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>force begun anew after %n stall(s)</source>
        <translation>
            <numerusform>force begun anew after %n stall</numerusform>
            <numerusform>force begun anew after %n stalls</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n force update(s) came late</source>
        <translation>
            <numerusform>%n force update came late</numerusform>
            <numerusform>%n force updates came late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DuelWindow</name>
    <message numerus="yes">
        <source>Go on with the interrupted one (%n answer(s))</source>
        <translation>
            <numerusform>Go on with the interrupted one (%n answer)</numerusform>
            <numerusform>Go on with the interrupted one (%n answers)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It takes %n trial(s); %1 right answers show the difference, which is found with %2 %.</source>
        <translation>
            <numerusform>It takes %n trial; %1 right answers show the difference, which is found with %2 %.</numerusform>
            <numerusform>It takes %n trials; %1 right answers show the difference, which is found with %2 %.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ExpertFlow</name>
    <message numerus="yes">
        <source>%n rule(s) · %1</source>
        <translation>
            <numerusform>%n rule · %1</numerusform>
            <numerusform>%n rules · %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelStatus</name>
    <message numerus="yes">
        <source>felt after %n tick(s)</source>
        <translation>
            <numerusform>felt after %n tick</numerusform>
            <numerusform>felt after %n ticks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FrameStatus</name>
    <message numerus="yes">
        <source>last %1 ms, median %2 ms, largest %3 ms of %n edit(s)</source>
        <translation>
            <numerusform>last %1 ms, median %2 ms, largest %3 ms of %n edit</numerusform>
            <numerusform>last %1 ms, median %2 ms, largest %3 ms of %n edits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HistoryPanel</name>
    <message numerus="yes">
        <source>Sign off what was felt: %n stroke(s) on this state, on %1 (Ctrl+Shift+G)</source>
        <translation>
            <numerusform>Sign off what was felt: %n stroke on this state, on %1 (Ctrl+Shift+G)</numerusform>
            <numerusform>Sign off what was felt: %n strokes on this state, on %1 (Ctrl+Shift+G)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MarksCard</name>
    <message numerus="yes">
        <source>Return to one of %n mark(s)</source>
        <translation>
            <numerusform>Return to %n mark</numerusform>
            <numerusform>Return to one of %n marks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MembershipEditor</name>
    <message numerus="yes">
        <source>All %n</source>
        <translation>
            <numerusform>All %n</numerusform>
            <numerusform>All %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ModelFiles</name>
    <message numerus="yes">
        <source>File, Show the notes of the file, lists %n more.</source>
        <translation>
            <numerusform>File, Show the notes of the file, lists %n more.</numerusform>
            <numerusform>File, Show the notes of the file, lists %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ModelHeader</name>
    <message numerus="yes">
        <source>%n expert(s)</source>
        <translation>
            <numerusform>%n expert</numerusform>
            <numerusform>%n experts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s)</source>
        <translation>
            <numerusform>%n rule</numerusform>
            <numerusform>%n rules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n notice(s)</source>
        <translation>
            <numerusform>%n notice</numerusform>
            <numerusform>%n notices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MonitorWindow</name>
    <message numerus="yes">
        <source>%1 · %n minute(s)</source>
        <translation>
            <numerusform>%1 · %n minute</numerusform>
            <numerusform>%1 · %n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::NotesButton</name>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::NumberPage</name>
    <message numerus="yes">
        <source>and %n more; point at a row of the table to read its own</source>
        <translation>
            <numerusform>and %n more; point at a row of the table to read its own</numerusform>
            <numerusform>and %n more; point at a row of the table to read its own</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PlacementCard</name>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ProtocolView</name>
    <message numerus="yes">
        <source>%n force(s), from %1 to %2 N.</source>
        <translation>
            <numerusform>%n force, from %1 to %2 N.</numerusform>
            <numerusform>%n forces, from %1 to %2 N.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) not stored.</source>
        <translation>
            <numerusform>%n change not stored.</numerusform>
            <numerusform>%n changes not stored.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) of the protocol are not stored.</source>
        <translation>
            <numerusform>%n change of the protocol is not stored.</numerusform>
            <numerusform>%n changes of the protocol are not stored.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PullCard</name>
    <message numerus="yes">
        <source>%n locked vertices stay where they are.</source>
        <translation>
            <numerusform>%n locked vertex stays where it is.</numerusform>
            <numerusform>%n locked vertices stay where they are.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n edits that are not plausible</source>
        <translation>
            <numerusform>Show %n edit that is not plausible</numerusform>
            <numerusform>Show %n edits that are not plausible</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It stays at %n place(s) with other inputs.</source>
        <translation>
            <numerusform>It stays at %n place with other inputs.</numerusform>
            <numerusform>It stays at %n places with other inputs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReadinessRow</name>
    <message numerus="yes">
        <source>and %n more, in the findings</source>
        <translation>
            <numerusform>and %n more, in the findings</numerusform>
            <numerusform>and %n more, in the findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RecordDialog</name>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s), none of them ever changed</source>
        <translation>
            <numerusform>%n line, which never changes</numerusform>
            <numerusform>%n lines, none of them ever changed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReferenceController</name>
    <message numerus="yes">
        <source>%1: found %n reference curve(s) together with those that are shown, wanted at most %2; remove some first.</source>
        <translation>
            <numerusform>%1: found %n reference curve together with those that are shown, wanted at most %2; remove some first.</numerusform>
            <numerusform>%1: found %n reference curves together with those that are shown, wanted at most %2; remove some first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleListPane</name>
    <message numerus="yes">
        <source>%n rule(s)</source>
        <translation>
            <numerusform>%n rule</numerusform>
            <numerusform>%n rules</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RulePanel</name>
    <message numerus="yes">
        <source>%1 of %n rule(s) act · %2</source>
        <translation>
            <numerusform>%1 of %n rule acts · %2</numerusform>
            <numerusform>%1 of %n rules act · %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n expert(s) have a rule here · mean %2</source>
        <translation>
            <numerusform>%1 of %n expert has a rule here · mean %2</numerusform>
            <numerusform>%1 of %n experts have a rule here · mean %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RulesLabView</name>
    <message numerus="yes">
        <source>%n cell(s) apart by more than one just-noticeable difference</source>
        <translation>
            <numerusform>%n cell apart by more than one just-noticeable difference</numerusform>
            <numerusform>%n cells apart by more than one just-noticeable difference</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SetupCheck</name>
    <message numerus="yes">
        <source>%n screen(s), %1</source>
        <translation>
            <numerusform>%n screen, %1</numerusform>
            <numerusform>%n screens, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of 1000 ticks a second 99 % are at most %1 ms late, positions %2 ms old; %n missed</source>
        <translation>
            <numerusform>Of 1000 ticks a second 99 % are at most %1 ms late, positions %2 ms old; %n missed</numerusform>
            <numerusform>Of 1000 ticks a second 99 % are at most %1 ms late, positions %2 ms old; %n missed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StrokesController</name>
    <message numerus="yes">
        <source>%n stroke(s) would meet a place where no rule fires.</source>
        <translation>
            <numerusform>%n stroke would meet a place where no rule fires.</numerusform>
            <numerusform>%n strokes would meet a place where no rule fires.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s), and no force changes.</source>
        <translation>
            <numerusform>%n stroke, and no force changes.</numerusform>
            <numerusform>%n strokes, and no force changes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>None of %n stroke(s) would feel different: at most %1 JND.</source>
        <translation>
            <numerusform>None of %n stroke would feel different: at most %1 JND.</numerusform>
            <numerusform>None of %n strokes would feel different: at most %1 JND.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n stroke(s), %1 would feel different: %2 most, by %3 at %4 mm.</source>
        <translation>
            <numerusform>Of %n stroke, %1 would feel different: %2 most, by %3 at %4 mm.</numerusform>
            <numerusform>Of %n strokes, %1 would feel different: %2 most, by %3 at %4 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) SIMULATED</source>
        <translation>
            <numerusform>%n stroke SIMULATED</numerusform>
            <numerusform>%n strokes SIMULATED</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) recorded with the force off: what they would meet</source>
        <translation>
            <numerusform>%n stroke recorded with the force off: what it would meet</numerusform>
            <numerusform>%n strokes recorded with the force off: what they would meet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) left out: felt on a model that the study does not keep.</source>
        <translation>
            <numerusform>%n stroke left out: felt on a model that the study does not keep.</numerusform>
            <numerusform>%n strokes left out: felt on a model that the study does not keep.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) left out: the recording is incomplete.</source>
        <translation>
            <numerusform>%n stroke left out: the recording is incomplete.</numerusform>
            <numerusform>%n strokes left out: the recording is incomplete.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) left out: their own model does not give the recorded force again. They were recorded with another version of the program, on a device that limits the spring, or during an edit.</source>
        <translation>
            <numerusform>%n stroke left out: its own model does not give the recorded force again. It was recorded with another version of the program, on a device that limits the spring, or during an edit.</numerusform>
            <numerusform>%n strokes left out: their own model does not give the recorded force again. They were recorded with another version of the program, on a device that limits the spring, or during an edit.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyFeature</name>
    <message numerus="yes">
        <source>%1 %n edit(s) of yours are in “%2”; Ctrl+B shows the new model and that version in turn.</source>
        <translation>
            <numerusform>%1 %n edit of yours is in “%2”; Ctrl+B shows the new model and that version in turn.</numerusform>
            <numerusform>%1 %n edits of yours are in “%2”; Ctrl+B shows the new model and that version in turn.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyHome</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyNoticeStrip</name>
    <message numerus="yes">
        <source>Show %n more</source>
        <translation>
            <numerusform>Show %n more</numerusform>
            <numerusform>Show %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TableImport</name>
    <message numerus="yes">
        <source>%n participant(s) imported from %1.</source>
        <translation>
            <numerusform>%n participant imported from %1.</numerusform>
            <numerusform>%n participants imported from %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TellController</name>
    <message numerus="yes">
        <source>At %n of 121 moments one of the two has no force; they are left out.</source>
        <translation>
            <numerusform>At %n of 121 moments one of the two has no force; it is left out.</numerusform>
            <numerusform>At %n of 121 moments one of the two has no force; they are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::VotesView</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tie(s)</source>
        <translation>
            <numerusform>%n tie</numerusform>
            <numerusform>%n ties</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n force(s) without votes</source>
        <translation>
            <numerusform>%n force without votes</numerusform>
            <numerusform>%n forces without votes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::WithdrawalDialog</name>
    <message numerus="yes">
        <source>%n version(s) of models stay without the rules of this participant.</source>
        <translation>
            <numerusform>%n version of a model stays without the rules of this participant.</numerusform>
            <numerusform>%n versions of models stay without the rules of this participant.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n version(s) of models stay as they are; the participant may have taken part in their terms.</source>
        <translation>
            <numerusform>%n version of a model stays as it is; the participant may have taken part in its terms.</numerusform>
            <numerusform>%n versions of models stay as they are; the participant may have taken part in their terms.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>session(s)</source>
        <translation>
            <numerusform>session</numerusform>
            <numerusform>sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>insertion(s)</source>
        <translation>
            <numerusform>insertion</numerusform>
            <numerusform>insertions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>judgement(s) of forces</source>
        <translation>
            <numerusform>judgement of forces</numerusform>
            <numerusform>judgements of forces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>answer(s) to questions</source>
        <translation>
            <numerusform>answer to questions</numerusform>
            <numerusform>answers to questions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>statement(s) about the person</source>
        <translation>
            <numerusform>statement about the person</numerusform>
            <numerusform>statements about the person</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>rating(s)</source>
        <translation>
            <numerusform>rating</numerusform>
            <numerusform>ratings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>rule(s) given directly</source>
        <translation>
            <numerusform>rule given directly</numerusform>
            <numerusform>rules given directly</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>recording(s) of feeling</source>
        <translation>
            <numerusform>recording of feeling</numerusform>
            <numerusform>recordings of feeling</numerusform>
        </translation>
    </message>
</context>
</TS>
