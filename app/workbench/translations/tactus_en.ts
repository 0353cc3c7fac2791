<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AgreementWords</name>
    <message>
        <source>Judged forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers to the form</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CollectText</name>
    <message>
        <source>Consent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Review</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not part of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>today %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in this file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ConsentWords</name>
    <message>
        <source>The study has no protocol: a person must be told whose study it is and whom to ask. To try the screens without one: tactus-workbench --rehearse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The protocol has no text of the study in %1: whose study it is, and who approved it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The protocol names nobody whom a participant can ask. To try the screens without a person: tactus-workbench --rehearse.</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>The lines of all experts; single ones under Forces here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the lowest to the highest force of the experts who have a rule there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± 1 SD</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Mean ± 1 standard deviation (n − 1) of the %n expert(s), where three or more have a rule. So few people say little about others; the range says what these said.</source>
        <translation>
            <numerusform>Mean ± 1 standard deviation (n − 1) of the %n expert, where three or more have a rule. So few people say little about others; the range says what these said.</numerusform>
            <numerusform>Mean ± 1 standard deviation (n − 1) of the %n experts, where three or more have a rule. So few people say little about others; the range says what these said.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the mean of the experts at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of the experts at the operating point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of the experts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CurveOverlays</name>
    <message>
        <source>Range of the experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean ± 1 standard deviation of the experts (n − 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step that a hand feels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CurveTable</name>
    <message>
        <source>As in %1: mean of the experts at %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DisplayText</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FigurePresets</name>
    <message>
        <source>Fig. 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>map and surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 10a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lubrication varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 10b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neck flexion varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 10c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>experts and mean</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FindingParts</name>
    <message>
        <source>Findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings (+%1)</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FindingWords</name>
    <message>
        <source>No rule of any expert fires: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rule fires: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rule mentions %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: against the declared direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: three levels or more at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: against most other steps of this expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The conditions are never true together: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source> (rule(s) %1)</source>
        <translation>
            <numerusform> (rule %1)</numerusform>
            <numerusform> (rules %1)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean jumps where this expert abstains: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean jumps from %1 to %2 where this expert abstains: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force steps from %1 to %2 within %3: %4 %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 where %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 against %2, the mean %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> where %1 is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the mean is near the force of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 was not asked about this region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, force from %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> where %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force goes the other way with %1 than for most experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force rises with %1, for most experts it falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force falls with %1, for most experts it rises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rule concludes %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redundant: a rule with fewer conditions already gives %2: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; no expert&apos;s force is near the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outside the universe of %2</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>No answer to item %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean jumps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Region without a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conflict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against the declaration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level jump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redundant rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule never fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unreachable term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unused term</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ForceTables</name>
    <message>
        <source>words of the force, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delivered against commanded force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GridWords</name>
    <message>
        <source>Felt, with the friction of the device: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least share of the force in the hand: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moved forward: %1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer after %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt again: %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hidden check; it is not counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not counted for the terms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GripText</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole term</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HelpMenu</name>
    <message>
        <source>&amp;About Tactus Workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Tactus Workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Tactus Workbench %1&lt;/h3&gt;&lt;p&gt;Turns what expert nurses know by feel into a force model that a haptic simulator can run.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later, without any warranty. It uses Qt %2 and QCustomPlot.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ImpactText</name>
    <message>
        <source>below %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 JND)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fills a hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves a hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no change of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max ΔF anywhere at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max ΔF on this curve at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔF &lt; %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔF ≥ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on this curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>InfluenceText</name>
    <message>
        <source>%1: without it there is no model: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: without it the averaged force is the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than 0.001 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: without it the averaged force moves by at most %2 (%3 just-noticeable differences), at %4; %5 rms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than 0.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt; 0.001 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 JND)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: without it the averaged force moves by less than 0.001 N everywhere.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabCaption</name>
    <message>
        <source>SIMULATED: data of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabSearch</name>
    <message>
        <source>Table 1: insertion speed of each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table 2: votes for each force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table 3: answers to the usability scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 3d: terms of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 3e: words of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 4: way of the tube on an image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 6: recordings of the strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 7: clusters of each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig. 8: speed terms of each participant, and their average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insertion length of a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judgements of the forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules of all experts, and the conflict map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings about the experts&apos; rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agreement of the experts (Krippendorff, Kendall, Fleiss)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights, and leaving one expert out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does a choice of the method matter?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fig.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure · %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Landmarks</name>
    <message>
        <source>Turbinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inferior turbinate, from its head to its posterior end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Posterior wall of the nasopharynx, where the way turns down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Epiglottis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip of the epiglottis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arytenoids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arytenoid cartilages and piriform sinuses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper sphincter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper esophageal sphincter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower sphincter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower esophageal sphincter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>Serving %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serving · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n connected</numerusform>
            <numerusform>%n connected</numerusform>
        </translation>
    </message>
    <message>
        <source>the last left at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none connected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MapTable</name>
    <message>
        <source>%1 over %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expert %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of the experts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MenuText</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fee&amp;l</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MethodCurvesTable</name>
    <message>
        <source>the averaged force with another choice of the method</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>%1, SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 of them SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built from the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built from the answers in %1: %2.</source>
        <translation type="unfinished"></translation>
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
    <name>NoteGroups</name>
    <message>
        <source>Look at the data first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes of the build</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the data first: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes of the build: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened to the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found when it was opened earlier</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NurseViewText</name>
    <message>
        <source>Welcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effort and comfort</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The words of the questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Review</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usability form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped for today</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No consent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, attempt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device rests before %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause before %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feels %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, insertion %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question %1, the form&apos;s item %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Region %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>being checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped for safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready, not held</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OptionText</name>
    <message>
        <source>Explore force models of expert nurses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture of every screen in &lt;folder&gt;, from the demo study, without a display.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of these pictures in px, before the scale; 1280x720 without this option.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WxH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale of these pictures: 2 for a screen with twice the dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of these pictures: en, zh-Hant or zh-Hans.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model (*.tactus.json) or a study (*.tactus).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the screens of the participants of &lt;study&gt;, and nothing else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated nurse does a whole session on the screens; ends when it is stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times faster than the clock the rehearsal is; 1 without this option.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study of the rehearsal or of the pictures; without this option a new one, or the demo study.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OriginText</name>
    <message>
        <source>not felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, stroke %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rule given directly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED: data of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model of the study has no such vertex: it was made by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study gives %1 with the settings of the labs. The vertex was moved by hand, or the model was built with other settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Averaged from %1 mm/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Votes at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Votes for %1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No participant said so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study says %1: the rule was changed by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer of the study gives a rule with these conditions: it was added by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study gives %1 with the settings of the labs; the model on the screen was edited, or built with other settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rule of the study&apos;s own model fires here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PictureParts</name>
    <message>
        <source>&amp;Copy picture of the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the plot with the keyboard or under the mouse</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotCaption</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contains simulated data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>membership functions of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terms of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shared terms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Procedure</name>
    <message>
        <source>Prepare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the nostril</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight back along the floor of the nose, not upwards. Small, steady strokes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass the bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind the nose the tube turns down. Rotate it a little if it holds; never push against a firm stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flex the neck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the throat ask the patient to bring the chin to the chest and to swallow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass the larynx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Advance with each swallow. Cough or breathlessness: draw back to the throat and wait.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down the esophagus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longer, even strokes. The head may come up again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reach the stomach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Past the lower sphincter go on to the measured length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fix and check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop. Fix the tube, and check where the tip lies before anything goes through it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explain what will happen. Sit the patient upright. Measure the length from nose to ear to xiphoid, and lubricate the tip.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PullTable</name>
    <message>
        <source>averaged force and the experts&apos; distances from it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReadinessText</name>
    <message>
        <source>Holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for places without a force…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>No rule fires at %n place(s): add a rule there, or accept each by its name.</source>
        <translation>
            <numerusform>No rule fires at %n place: add a rule there, or accept it by its name.</numerusform>
            <numerusform>No rule fires at %n places: add a rule there, or accept each by its name.</numerusform>
        </translation>
    </message>
    <message>
        <source>The model is too finely divided to find every place without a force; there may be more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>At %n accepted place(s) no rule fires; the force there is %1.</source>
        <translation>
            <numerusform>At %n accepted place no rule fires; the force there is %1.</numerusform>
            <numerusform>At %n accepted places no rule fires; the force there is %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Every place has a force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conflicts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for rules that contradict each other…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of rules have the same conditions and different forces.</source>
        <translation>
            <numerusform>%n pair of rules has the same conditions and different forces.</numerusform>
            <numerusform>%n pairs of rules have the same conditions and different forces.</numerusform>
        </translation>
    </message>
    <message>
        <source>No two rules of an expert contradict each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is of one expert.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the experts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>At %n place(s) two experts are more than two just-noticeable differences apart, by up to %1.</source>
        <translation>
            <numerusform>At %n place two experts are more than two just-noticeable differences apart, by up to %1.</numerusform>
            <numerusform>At %n places two experts are more than two just-noticeable differences apart, by up to %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>No two experts are more than two just-noticeable differences apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign off…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 signed off this state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>No expert has signed off the last %n edit(s).</source>
        <translation>
            <numerusform>No expert has signed off the last edit.</numerusform>
            <numerusform>No expert has signed off the last %n edits.</numerusform>
        </translation>
    </message>
    <message>
        <source>Origin of the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some data are simulated: the model and the report of the bundle say so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say what data the model is from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify a bundle…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bundle of this model has been made and read back yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bundle %1 does not hold what it promises.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is not the one in the bundle %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bundle %1 was read back: each file is within its tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) to settle first</source>
        <translation>
            <numerusform>%n thing to settle first</numerusform>
            <numerusform>%n things to settle first</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To settle first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 approved this state without feeling it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>0 of %n expert(s) have approved this version.</source>
        <translation>
            <numerusform>0 of 1 expert have approved this version.</numerusform>
            <numerusform>0 of %n experts have approved this version.</numerusform>
        </translation>
    </message>
    <message>
        <source>Steps of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for steps of the force…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>At %n place(s) the force steps within 1 mm or faster than it can be rendered, by up to %1.</source>
        <translation>
            <numerusform>At %n place the force steps within 1 mm or faster than it can be rendered, by %1.</numerusform>
            <numerusform>At %n places the force steps within 1 mm or faster than it can be rendered, by up to %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The force steps nowhere by more than can be felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes on the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open study has no note on this model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say with which settings the model was built.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was built with the published settings.</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>VIRTUAL, a device that gives no force: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data are marked as simulated or as given on a device without force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) open; a bundle can be made</source>
        <translation>
            <numerusform>%n thing open; a bundle can be made</numerusform>
            <numerusform>%n things open; a bundle can be made</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation type="unfinished"></translation>
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
</context>
<context>
    <name>RecentText</name>
    <message>
        <source>today %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReviewNotes</name>
    <message>
        <source>These notes are of a build from the answers as they are now. The model of the study began as another one: built with other settings, from other answers, or put in from a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No model is built of this: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleBlock</name>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleParts</name>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleRowText</name>
    <message>
        <source>%1 is %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleWeight</name>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SearchText</name>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ServoLoop</name>
    <message>
        <source>loop of the driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real-time thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ordinary thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShownFindingText</name>
    <message>
        <source>Acceptance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accepted, but there is no such hole any more: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StageText</name>
    <message>
        <source>Collect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Understand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tune</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maps, curves and rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terms and their force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bundle for a simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sessions with nurses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>experts side by side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatisticWords</name>
    <message>
        <source>JND: just-noticeable difference, √(0.04² + (0.12 F)²) N around a force F. A change below 1 JND is too small to feel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS: the root of the mean squared difference. Large differences count more than in a mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % interval: the data are drawn again many times, and 95 % of the draws give a value in this range. A wide one says that there are few data, or that they contradict each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Krippendorff&apos;s alpha: agreement beyond chance. 1 is full agreement, 0 what chance gives, less than 0 worse than chance. Ordinal: the order of the words counts; interval: their distances count too; nominal: two words are the same or not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fleiss&apos; kappa: agreement beyond chance, from 1 for full agreement to 0 for what chance gives. It takes no account of the order of the words: neighbors count as different as the ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ, kappa with quadratic weights: how well one person&apos;s answers to equal forces agree beyond chance. 1 is full agreement, 0 what chance gives; a word two steps away counts four times as much as a neighbor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kendall&apos;s W: how similarly the participants order the forces or items. 1 is one order of all, 0 no common order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consensus: 1 if all say the same word, 0 if half say the lowest and half the highest; the mean of the forces or items.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyContentsText</name>
    <message>
        <source>%1: %2. If records are missing, look for them in a backup or an export of the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) who withdrew</source>
        <translation>
            <numerusform>a participant who withdrew</numerusform>
            <numerusform>%n participants who withdrew</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the erasure of %2 was interrupted. Traces of the data can still be in the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SubjectTitle</name>
    <message>
        <source>%1 (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 of %3 samples</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TermForms</name>
    <message>
        <source>Split %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Its %n rule(s) are copied to each part, so the force stays as it is until you change a part.</source>
        <translation>
            <numerusform>Its rule is copied to each part, so the force stays as it is until you change a part.</numerusform>
            <numerusform>Its %n rules are copied to each part, so the force stays as it is until you change a part.</numerusform>
        </translation>
    </message>
    <message>
        <source>Number of parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts (%1):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Type the cuts with semicolons between them, such as 290; 365.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Drag:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TraceTable</name>
    <message>
        <source>Felt on: %1, a simulated device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt on: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force felt in the last %1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TypedNumber</name>
    <message>
        <source>A number is missing: type one such as 13.5 or 13,5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has more than one decimal mark: type a number such as 1234.5 or 1234,5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no number: type one such as 13.5 or 13,5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no whole number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” can be one number or two: type %2 or %3.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>VoteWords</name>
    <message>
        <source>half or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tie, the higher wins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no half, next level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next level, limited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no votes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, raised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, below quorum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One word has half of the votes or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two words have half of the votes each: the higher one wins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No word has half. The forces rise, so one word above that of the force before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No word has half. One word above that of the force before, moved into the words with votes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No word has half and no force was decided before: the lower median.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Raised to the word of a smaller force: words must not fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Fewer than half of the participants voted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rising forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falling forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>random order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No participant chose a word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trapezoids closest to the shares of all answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of the participants&apos; own limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The winner of each force (the paper).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ordered probit over all answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, nobody said it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, not the most frequent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Nobody said this word here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Another word was said more often.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::AgreementTable</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Krippendorff&apos;s alpha for ordered words: 1 is full agreement, 0 what chance gives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % of 2,000 draws of the forces or items; the participants stay the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tastle and Wierman: 1 if all say the same, 0 if half are at each end; mean of the forces or items.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes no account of the order of the words: neighbors count as different as the ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How similarly the participants order the forces or items, from 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units × raters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ordinal alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consensus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fleiss&apos; kappa</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::AutosaveController</name>
    <message>
        <source>The file was changed by another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The history of %1 does not go on: %2. It is kept in %3, which opens as a study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed %1 after %2. Undo leads back to the state before; History has all others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autosave failed, so a crash would lose the changes of the model: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The earlier history of %1 was not read. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::AxisZoom</name>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the airway, 0 to 250 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::BandLab</name>
    <message>
        <source>One participant alone says nothing about others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same participants once more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As many other participants like these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One more participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, 95 % at each depth by itself: at most ± %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to %1 % of the draws give no force somewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unfinished: %1 of %2 draws.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::BundleMaker</name>
    <message>
        <source>Canceled: nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a bundle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bundle was not read. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bundle was not made. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::BundlePanel</name>
    <message>
        <source>Make the bundle…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bundle is one folder with everything that a simulator team needs, and how exact each file is:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points with their exact forces, to test a reader of one&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each expert for fuzzylite, jFuzzyLogic, MATLAB, Octave and IEEE 1855</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a look-up table, where nothing else is possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model on two printed pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the bundle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of the bundle, with the largest error of each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a model first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settle the holes first: a simulator must know where there is no force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making %1: part %2 of %3…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1 back…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canceling…</source>
        <translation type="unfinished"></translation>
    </message>
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
    <message>
        <source>Not every file is what it promises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open model is another one: its forces differ, or how it is felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the native file, for libtactus: C, C++, Python and C#</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fastest way to a force, without any library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder was not opened, because no program of this computer shows folders. The bundle is in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy its path</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CellTable</name>
    <message>
        <source>not asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the averaged force moves without this rule, at most, and in just-noticeable differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No expert has a rule here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All say the same here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With each other&apos;s word the experts would feel %1 more or less: %2 just-noticeable differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With each other&apos;s word the experts would feel %1 more or less: not noticeable (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If all said %1, the mean would move by %2, and %3 % of the disagreement would vanish.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given directly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If all said %1, the mean would move by %2, and the disagreement would grow by %3 %.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CheckTable</name>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % near</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falling words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rising – falling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blanks felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits between words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs of forces in which the larger one got the lower word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean word in the rising series less that in the falling series, at equal forces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agreement of the answers to equal forces: kappa with quadratic weights, and the share within one word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blanks of 0 N that were judged as felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ordered probit: the force at which one word gives way to the next, and the spread of what is felt.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CheckView</name>
    <message>
        <source>Checks of the judgements</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ClusterPage</name>
    <message>
        <source>gray: samples · lines: membership in each cluster · dotted: its center, 95 % interval at the foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clusters of each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms: each participant’s and the average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is averaged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No terms: their number is not that of the clusters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ramps %1 mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c %1 · m %2 · α %3 · trimming %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clusters of insertion speeds (paper, Fig. 7)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data are simulated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed terms of each participant and their average (paper, Fig. 8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strokes of the study are being read and clustered…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>▲ no clusters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clusters of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CollectController</name>
    <message>
        <source>The participants of %1 were not read. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read them again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No participant was added. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would be deleted was not counted. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not withdrawn. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CollectParts</name>
    <message>
        <source>Version %1 of the protocol is stored in %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The research key is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The research key is removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything of %1 is deleted from %2. Backups and exports made before can still hold the data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session did not begin. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the key again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw again…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CommandSearch</name>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a command, panel, expert, term or finding; or a place: 130 mm poor fast</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareCard</name>
    <message>
        <source>Go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No difference of the force was found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 JND from A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · RMS %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In places only one of the two has a force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A %1, B %2 at %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A: the reference version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B: the version to compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the operating point to the largest difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No term, rule or setting differs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n term(s), rule(s) or setting(s) differ from A to B:</source>
        <translation>
            <numerusform>%n term, rule or setting differs from A to B:</numerusform>
            <numerusform>%n terms, rules or settings differ from A to B:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareController</name>
    <message>
        <source>Snapshot “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed off by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Open model, mean of %n expert(s)</source>
        <translation>
            <numerusform>Open model, mean of %n expert</numerusform>
            <numerusform>Open model, mean of %n experts</numerusform>
        </translation>
    </message>
    <message>
        <source>Open model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before the last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to compare: A and B are the same model. Choose two in the panel History.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You edited the open model, so the comparison has ended. The device renders the open model again, not “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareStrip</name>
    <message>
        <source>End comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show and feel the open model again (Ctrl+Shift+B)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown is %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On screen and device: %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CompareSwitch</name>
    <message>
        <source>Show and feel %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show and feel A: %1 (Ctrl+B)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show and feel B: %1 (Ctrl+B)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::Corrections</name>
    <message>
        <source>Undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stored: %1. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CurveLegend</name>
    <message>
        <source>Show or hide the lines that find no place here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further lines</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CurveParts</name>
    <message>
        <source>Lay a reference curve over the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open re&amp;ference curve…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture of the curves…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in at the operating point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;whole axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure from the operating point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reference curve is not shown. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another curve…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CurvePlot</name>
    <message>
        <source>Force curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where does the force here come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CurvesPanel</name>
    <message>
        <source>Before the last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input on the x axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: step %2 to %3 (%4 JND) at %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the curves before an edit as dashed lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since then: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (since then: %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dashed: %1%2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference %1 and %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the operating point to where the last edit changes the force most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::CutPicture</name>
    <message>
        <source>Cuts of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a cut, or choose it with the arrows up and down and move it with left and right</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeliverParts</name>
    <message>
        <source>Readiness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bundle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin of the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say what data the model is from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the bundle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of a bundle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes on the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open study has no note on this model.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeliveredModel</name>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middles of %1 cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear between nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not as promised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centroid</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeliveredPlot</name>
    <message>
        <source>No delivered force was measured.</source>
        <translation type="unfinished"></translation>
    </message>
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
    <message>
        <source>Delivered against commanded force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded force (N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force in the hand (N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discs: the least force while it was judged. Circles: the force with the friction of the device.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DemoMaker</name>
    <message>
        <source>Four simulated nurses go through their sessions…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Their answers become a model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tables and figures of the report are drawn…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files are written…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo study was not made. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthCanvas</name>
    <message>
        <source>Image with the way of the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 | %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a sagittal image, or look at the example. Then click along the way of the tube, from the nostril to the stomach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 | %2  %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthLab</name>
    <message>
        <source>image %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the example</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anatomy drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored measurement was not read. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was not stored. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthLabView</name>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel: zoom · right button: move the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click both ends of a line whose length you know.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a sagittal image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of this line (mm):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale of the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insertion length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converting %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several images</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds %2 images. Which one?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study has a copy of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not loaded. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another image…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is larger than the %1 MB that a study takes: save it with fewer pixels, or as JPEG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale was not set. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored image is not shown. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings of the depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthSettingsPanel</name>
    <message>
        <source>Millimeters per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anatomical scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All depths of the terms times this factor: 0.93 for a small adult, 1.05 for a large one. The measurement stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Load an image…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One pixel is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Way of the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundaries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale of the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anatomical scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overlap ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 | %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlap of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet. A sagittal image (PNG, JPEG, TIFF) through the middle of head and trunk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n point(s), %1 mm from the nostril to the end</source>
        <translation>
            <numerusform>%n point, %1 mm from the nostril to the end</numerusform>
            <numerusform>%n points, %1 mm from the nostril to the end</numerusform>
        </translation>
    </message>
    <message>
        <source>Click along the way on the image, from the nostril on. Drag a point to move it, Del removes it; drag a red circle to the boundary of two regions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark a &amp;known length…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show the example</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthTermPage</name>
    <message>
        <source>Terms of the insertion depth, measured on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one pixel is %1 mm · anatomical scale %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;pths of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is measured yet: load an image, or set a boundary.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose which depths the study&apos;s model has, here, in the report and in the bench.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DepthTermPlot</name>
    <message>
        <source>Terms of the depth</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for haptic devices on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release zone of the latch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No hardware: hand, device and force are calculated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel the open model (F9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2). No force until you arm again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If pushing in pulls out: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tripped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: nothing is computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a model to feel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting the device…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No force. The device is stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tripped: no force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go of the tube, then it arms again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edit felt after %1 (longest %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n tick(s) late</source>
        <translation>
            <numerusform>%n tick late</numerusform>
            <numerusform>%n ticks late</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>force begun anew after %n stall(s)</source>
        <translation>
            <numerusform>force begun anew after %n stall</numerusform>
            <numerusform>force begun anew after %n stalls</numerusform>
        </translation>
    </message>
    <message>
        <source>How to hold the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press once to hold the tube, press again to release it. No need to squeeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the device and how the tube is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device did not start. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the device on which the model is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the tube while the button of the device, the mouse button or Space is down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the release zone: a hand that is drawn out further than this lets go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the force with the next tick (F12, or Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::DeviceSession</name>
    <message>
        <source>The device before is still starting or stopping; try again when it has stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The loop of the device&apos;s driver has ended: %1. Look at cable and supply of the device, then start again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::EditController</name>
    <message>
        <source>Undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot “%1” of: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move stopped at its limit: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::EditParts</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Membership function editor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ExpertFlow</name>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>× %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s) · %1</source>
        <translation>
            <numerusform>%n rule · %1</numerusform>
            <numerusform>%n rules · %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ExpertsLabView</name>
    <message>
        <source>&amp;Open in the bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights of the experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights, and leaving one expert out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights and what leaving one expert out changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight policies beside equal weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances between experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who pulls where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curves are drawn at this value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band around the averaged force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band: the experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choice of weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the band that says how far the averaged force can be trusted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the averaged model to the study as another model, and go on to tuning.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FactorTable</name>
    <message>
        <source>Choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does it matter here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the difference over the input space, in just-noticeable differences, for the value that moves the force most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelController</name>
    <message>
        <source>No model is open; open one to feel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another part of the program uses the device; stop it there first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device does not render the edit: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelPanel</name>
    <message>
        <source>Split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what makes up the force: fuzzy force, friction and limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the device rests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the device is silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program was silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vibration damped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the force cap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fading in after a stall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fading in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spring softened to %1 N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move depth and speed of all plots with the tube in the hand</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelParts</name>
    <message>
        <source>Feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start on the chosen device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top: no force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Flex the neck, or raise the head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New placement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the Feel &amp;layout</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelStatus</name>
    <message>
        <source>Feel: starting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel: stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel: stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel: tripped, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel: running, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>felt after %n tick(s)</source>
        <translation>
            <numerusform>felt after %n tick</numerusform>
            <numerusform>felt after %n ticks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FeelStore</name>
    <message>
        <source>The recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The end of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded into %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples of the recording were lost, because this program came to a standstill. The recording says where.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording into %1 has ended, because the model has other inputs now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A piece of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The placement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The placement is stored in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not stored in %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was not replayed. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has no channels &apos;time&apos; and &apos;force&apos;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FigureButton</name>
    <message>
        <source>Figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the inputs as in a figure of the paper, and show the curves it shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts and mean</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FindingDelegate</name>
    <message>
        <source>Accepted: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lapsed acceptance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 JND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FindingTable</name>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At stake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is found; a click leads to the cell</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FindingsController</name>
    <message>
        <source>Remove it from the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model changed since this fix was made; the new findings will be there in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FindingsModel</name>
    <message>
        <source>Click to see each of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>≥: the largest force of the tested settings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FindingsPanel</name>
    <message>
        <source>Which findings are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose findings are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All findings (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search for holes was cut off: the model is too finely divided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for holes, conflicts and jumps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing found: every place has a force, no two rules contradict each other, and no step of the force is against the declared directions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reachable force: %1 to %2 of the universe from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is very large, so only some forces were computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By newtons</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::FixCard</name>
    <message>
        <source>Go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model changed: looking again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for what would settle it…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No edit settles this by itself: look at the rules together with the expert.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the operating point to the place of this force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the operating point to the start of the change of force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select this rule in the rule editor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceBar</name>
    <message>
        <source>Force on the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cap %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceLab</name>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2: %3 instead of %4</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceLabView</name>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series that votes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Votes for each force (Table 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judgements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delivered force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of the force (Fig. 3e), four ways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the series that votes for the words of the force.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceMapController</name>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceMapPlot</name>
    <message>
        <source>Force over two inputs as a map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceOffButton</name>
    <message>
        <source>Force off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc · F12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the force with the next tick, whatever has the keyboard (F12, or Esc outside a drag)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForcePlot</name>
    <message>
        <source>Force of the last seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No device is in use.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceTermsPlot</name>
    <message>
        <source>Words of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: where does this corner come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceTermsView</name>
    <message>
        <source>Take the words of the force in the model from here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ForceTracePlot</name>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force of the last ten seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>present model, calculated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fuzzy force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Plots after %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From an edit until every visible plot is painted with it: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until map and surface are at their finest: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A screen of 60 Hz shows a picture every 16.7 ms.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::GhostController</name>
    <message>
        <source>Before the last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 JND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2) at %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2, %3 at %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fills a hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves a hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no change of this curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max ΔF on this curve at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · on this curve at least %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No change here: acts at %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::GridsView</name>
    <message>
        <source>Rules of all experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the rules…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apart, in N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 between two experts, %2 just-noticeable differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Item %1 of the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A rule given directly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected; the old record stays in the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: correct to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skipped</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::GuideWindow</name>
    <message>
        <source>Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HelpParts</name>
    <message>
        <source>The force on the way of the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each thin line is one nurse, the thick one is their mean. Move the mouse over the curves to read them; turn the wheel to come closer. A gap is a place for which no nurse gave a rule.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One place for everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lubrication, neck, depth and speed: this is the situation that all panels speak of. Type a number, or click into the curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why this force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rules that speak at this place, the strongest first, and what each of them pulls the force to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force for every depth and speed at once. Sharp edges are places where one word ends and the next begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change what a word means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a corner: the curves follow while you drag. Ctrl+Z takes everything back, and the history keeps every state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to look at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes, contradictions and jumps of the force, largest first. Where a repair is plain, one click does it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Start (F9), hold Space and move the mouse over the pad: the tube resists as the model says. No device is needed. F12 or Esc takes the force away; F10 makes this the whole window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand it to a simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is missing before the model can be delivered, and the bundle for the people who build the simulator. The guide (F1) tells the rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the &amp;guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the five-minute &amp;tour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HereParts</name>
    <message>
        <source>Membership functions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HistoryModel</name>
    <message>
        <source>Snapshot “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed off: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click goes back to it; nothing is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: a click brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: feels right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An earlier branch. Click to return to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: approved unfelt</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HistoryPanel</name>
    <message>
        <source>Name it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feels right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare, sign off ›</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert who signs off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to this state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare: this is A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare: this is B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve unfelt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‹ Show versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name the current state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the current state under this name (Ctrl+Shift+N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the expert&apos;s code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter your name, the author of your edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Sign off what was felt: %n stroke(s) on this state, on %1 (Ctrl+Shift+G)</source>
        <translation>
            <numerusform>Sign off what was felt: %n stroke on this state, on %1 (Ctrl+Shift+G)</numerusform>
            <numerusform>Sign off what was felt: %n strokes on this state, on %1 (Ctrl+Shift+G)</numerusform>
        </translation>
    </message>
    <message>
        <source>Approve this state without feeling it: the sign-off will read “approved without feeling”. Feel one stroke on it for “feels right” (Ctrl+Shift+G)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::HistoryParts</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name this state…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sign off by an expert…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare: switch between A and B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;End the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter &amp;your name…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::InputCard</name>
    <message>
        <source>in no term</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::JudgementGrid</name>
    <message>
        <source>Corrected; before: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::JudgementView</name>
    <message>
        <source>Judgements of each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series of forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a judgement to correct it. The old one stays in the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2: %3, corrected to</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LabParts</name>
    <message>
        <source>Building the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored as a new record; the old one stays: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clustering the speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counting the votes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing participants again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the choices of the method</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LabScreen</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1… %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canceled: what you see is not complete. The next change computes again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: nothing was changed here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: nothing was undone here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The labs show nothing of this study. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LegendChip</name>
    <message>
        <source>Show or hide: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LengthPage</name>
    <message>
        <source>Insertion length by bedside formulas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nose – ear – xiphoid %1 · anatomical scale %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nose – ear – xiphoid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Nose – ear – xiphoid of a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hanson: 0.38696 × length + 30.37 cm; corrected: 0.38696 × length + 36.37 cm (Hanson 1979, biblio.ugent.be/publication/8599660). The plain length is too short in 96.7 % of people, gauged by the tip (Chen 2014, PMC3919749). Target: Boeykens 2023, Crit Care 27:317. The tilt of the head can change the needed length by up to 5 cm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nose – ear – xiphoid length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formula</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored with the study. It moves neither the terms nor the target; the anatomical scale at the left moves both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An example: type the length of a person. It moves neither the terms nor the target; the anatomical scale at the left moves both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tip should lie %1 to %2 from the nostril: 3 to 10 cm beyond the lower esophageal sphincter, which is the boundary of esophagus and stomach, here at %3 (scale %4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 too short</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beyond sphincter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the length from the tip of the nose over the lobe of the ear to the end of the breastbone, along the tube.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LengthPlot</name>
    <message>
        <source>Nose – ear – xiphoid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hanson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tube by each formula</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the nostril (cm)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LinkController</name>
    <message>
        <source>No model is open; open one to serve it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LinkDialog</name>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Token file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the path of the token file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serve to a simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Programs of yours on this computer get the model that is shown, and each edit of it at once. They also get what the hand feels, while you feel the model. The program starts with this switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulator without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2), follows the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No simulator can connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a simulator the address and the token file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any free port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one if your simulator expects a fixed port; 0 takes any free one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulators: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No simulator is served. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take any free port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LinkParts</name>
    <message>
        <source>Serve to a s&amp;imulator…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulators can connect to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulators are no longer served.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last simulator has left.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LinkRow</name>
    <message>
        <source>Live link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off. A running simulator can follow each edit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serve to a simulator…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who is connected…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::LinkSign</name>
    <message>
        <source>Click to see who is connected, or to stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MainWindow</name>
    <message>
        <source>Tactus Workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the &amp;window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MapChoice</name>
    <message>
        <source>Whose force is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input on the x axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input on the y axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MapPanel</name>
    <message>
        <source>A map needs a model with two inputs.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MapParts</name>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture of the &amp;map…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MembershipEditor</name>
    <message>
        <source>Own terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms sum to one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add term…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared terms (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It goes no further: stopped by %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>All %n</source>
        <translation>
            <numerusform>All %n</numerusform>
            <numerusform>All %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit for %1 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit for all who share the terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 share these terms. Edit for %2 only, or for all of them? Choose above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared terms: edit for %1 only, or for all? Choose above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a term to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The term that holds this place makes room for the new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the new term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the new term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new term needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shared terms (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terms of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: shared terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the sum of memberships at one: a vertex moves together with its neighbor&apos;s vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a vertex, an edge or a term. Arrow keys move it, Shift+arrow in larger steps; Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where from?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the shared terms, or the terms of one expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the expert terms of its own for this variable; otherwise the shared ones hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the expert their own terms for this variable; the terms of the others do not change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the terms of all experts who share them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the trials of the study behind the selected vertex</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MembershipEditorPlot</name>
    <message>
        <source>Membership functions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · stopped by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where does this vertex come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MembershipPlot</name>
    <message>
        <source>Terms of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MessageBanner</name>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MethodLabView</name>
    <message>
        <source>&amp;Compare the choices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the comparison is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choices of the method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of the choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the choice matter here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every value of this choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it moves the force most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Building the averaged model with one choice changed at a time…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Builds the averaged model again with one choice of the method changed at a time, and compares the forces. With four participants this takes some seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study or a setting has changed since: compare again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared at %1 points spread evenly over the inputs. A choice matters if another value is felt at more than %2 % of them. Choose a row to see where.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thick: as it is, with one just-noticeable difference around it. Thin: %1. Drawn at %2; the largest difference is %3 at %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 moves the force nowhere. Drawn at %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MethodPlot</name>
    <message>
        <source>Averaged force as it is and with another choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where they differ most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not noticeable: within one just-noticeable difference</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ModelFiles</name>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a model or a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force models (*.tactus.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts of the file were not used: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> – study %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactus Workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models and studies (*.json *.tactus *.fll *.fcl *.fis);;Force models (*.json);;Studies (*.tactus);;Models of other programs (*.fll *.fcl *.fis *.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which output is the force?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model was imported. %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a model of another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models of other programs (*.fll *.fcl *.fis *.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New NGT model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reop&amp;en</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> – study %1 (read-only)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;notes of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>File, Show the notes of the file, lists %n more.</source>
        <translation>
            <numerusform>File, Show the notes of the file, lists %n more.</numerusform>
            <numerusform>File, Show the notes of the file, lists %n more.</numerusform>
        </translation>
    </message>
    <message>
        <source>No new model was made. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ModelHeader</name>
    <message>
        <source>Te&amp;rms:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose terms are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contains simulated data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study that is open: placements, recordings and versions of its model go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared</source>
        <translation type="unfinished"></translation>
    </message>
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
    <message>
        <source>Look at the data first: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n notice(s)</source>
        <translation>
            <numerusform>%n notice</numerusform>
            <numerusform>%n notices</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open for reading only, because %1. Study, Save a copy of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study %1, read-only</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MonitorController</name>
    <message>
        <source>skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can&apos;t tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts are done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session was ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant has called you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session has begun: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, insertion %2%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (practice)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not recorded, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, not scored: only %2 % of the force was delivered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, not scored</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::MonitorWindow</name>
    <message>
        <source>Add the note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session – Tactus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of this part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Talked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grip changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds this note with the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the session to type: the keyboard is the participant&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force: commanded (filled) and delivered (line)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Course of the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant calls you. The force is off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device has stopped. Nothing is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stored, and tried again every few seconds: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant has switched the force off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 N: cut by a limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No participant yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::NoteParts</name>
    <message>
        <source>&amp;Look at the data first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what &amp;happened to the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the n&amp;otes of the build</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Table 1: speeds of each participant at each level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objective against iteration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: clusters and levels agree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more; point at a row of the table to read its own</source>
        <translation>
            <numerusform>and %n more; point at a row of the table to read its own</numerusform>
            <numerusform>and %n more; point at a row of the table to read its own</numerusform>
        </translation>
    </message>
    <message>
        <source>Table 1: insertion speed in mm/s, and how clusters and levels agree</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ObjectivePlot</name>
    <message>
        <source>Objective against iteration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J / its minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iteration of the textbook</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OperatingStrip</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the last edit to the first force that uses it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the operating point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Changes not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a value of %1, or change it with the arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OriginParts</name>
    <message>
        <source>No study is open: the records behind a model are in its study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not built from records: no study is behind its numbers, and none of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was built from the study %2, which is not open. Open it to see the records behind the model; those of %3 are not.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OriginTable</name>
    <message>
        <source>no model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the averaged force moves without this record, at most, and in just-noticeable differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OriginWindow</name>
    <message>
        <source>Show in the lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records behind the number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Building the model of the study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the force with and without it…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OutputCard</name>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::OutputSetsPlot</name>
    <message>
        <source>Clipped sets of the output and their centroid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centroid %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PairTable</name>
    <message>
        <source>At most %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PanelArea</name>
    <message>
        <source>Panels that share a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put back into the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PanelTitle</name>
    <message>
        <source>Close this panel; View ▸ Panels brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put back into the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put %1 back into the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 out of the window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PartList</name>
    <message>
        <source>Speed: insertions at a named speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces: a word for each force that is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions: the force in 45 situations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move earlier: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move later: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ParticipantTable</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, VIRTUAL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VIRTUAL</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PatientControls</name>
    <message>
        <source>Lubrication</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flex the neck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flex the neck or raise the head within a second; the force follows (F8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the lubrication to %1</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>New placement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the tube out and begin again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A summary follows when the placement ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s, %2, %3, peak %4, mean %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last replay, SIMULATED: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last placement, SIMULATED: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last placement: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PlotMenu</name>
    <message>
        <source>Copy or save this plot, as a picture or as a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy or save this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save table…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture copied: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table copied: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture for the screen (*.png);;Drawing for a web page (*.svg);;Drawing for print (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PolicyTable</name>
    <message>
        <source>Equal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By years of experience</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the experts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From equal, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ProcedurePanel</name>
    <message>
        <source>%1 of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ProtocolController</name>
    <message>
        <source>Found %1, wanted %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The protocol of %1 was not read. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The protocol stays as it was. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The research key stays as it was. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ProtocolField</name>
    <message>
        <source>Undo the change of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo this change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set back to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ProtocolView</name>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insertions at each speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow, medium and fast each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice before them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slow, medium, fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn for each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ascending series of the published experiment, and two additions against its errors of habituation and expectation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With commas between them. They are felt, not judged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ascending series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends at “beyond what I meet in practice”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Descending series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where the ascending one ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces in an order drawn for each participant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random: lowest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random: highest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random: step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random: times each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random: share of catch trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blanks and hidden repeats: 0.1 to 0.15, or 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause before each force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longer where the device must rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest hold of a large force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A rest after every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: no rests.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts at a force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A judgement without movement, or of a force that was cut, is asked again so often.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the questions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as in the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Languages and consent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version of the consent text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored with each consent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consent text, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device that the forces are meant for. A force that it cannot hold is refused here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: any device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its own friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured against forward motion; added to the felt force. Empty: not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest continuous force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.88 N for a Touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Research key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The passphrase that leads from the participant&apos;s screens back to this window. It is stored as a hash and can be changed at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New research key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same key again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New key, at least %1 letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A key is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least %1 letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two are not the same yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device can hold %1 N for %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n force(s), from %1 to %2 N.</source>
        <translation>
            <numerusform>%n force, from %1 to %2 N.</numerusform>
            <numerusform>%n forces, from %1 to %2 N.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Discard the changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Store</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections of the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‹ &amp;Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why does it change?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason of the change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none is stored yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version %1, which participants follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version %1, a draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Store version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One setting has to be corrected first. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Storing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants follow version %1. The change becomes version %2, for the sessions from now on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the protocol before the first session. It stays a draft until a participant follows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) not stored.</source>
        <translation>
            <numerusform>%n change not stored.</numerusform>
            <numerusform>%n changes not stored.</numerusform>
        </translation>
    </message>
    <message>
        <source>Everything is stored. A change would become a new version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stored. The first session will lock it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes not stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) of the protocol are not stored.</source>
        <translation>
            <numerusform>%n change of the protocol is not stored.</numerusform>
            <numerusform>%n changes of the protocol are not stored.</numerusform>
        </translation>
    </message>
    <message>
        <source>What a session consists of, in this order. The practice before each part is not counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The consent screen makes general statements of the parts and the device above. Below them stands this text: who runs the study, the approval of the ethics committee; then whom to ask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whom a participant can ask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name and a telephone number. Without it no session of a person begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instead of the general statements, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: the general ones, which follow the parts and the device.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::PullPlot</name>
    <message>
        <source>Averaged force and the experts&apos; distances from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the lowest to the highest expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the mean (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not noticeable: within one just-noticeable difference</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReadinessRow</name>
    <message>
        <source>Accept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept the hole %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept that there is no force here; the model keeps the name of the hole (undo: Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the findings</source>
        <translation>
            <numerusform>and %n more, in the findings</numerusform>
            <numerusform>and %n more, in the findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReadingModel</name>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (weight %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReadingPanel</name>
    <message>
        <source>Forces at the place that is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move over the curves to read them. Click to keep the place, Shift+click to measure from it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RecordingsCard</name>
    <message>
        <source>Researcher (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who feels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End · %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
felt on the model %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into the study %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record hand and force into the study, from a new placement on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is open for reading only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study keeps what is felt: one file, a new one or one that is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record into a study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the study file; the recording then begins with Start (F9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose for whom placements and recordings are stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the recorded hand move the tube through the present model, by calculation; the recorded force stands beside the present one in the trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm a recording: it begins with Start (F9), and goes into the study %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel the recording, which begins with Start (F9)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RecoveryController</name>
    <message>
        <source>Restored: %1, edits: %2, with their history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edits of %1 were not restored, because another window has them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edits of %1 were not restored. Their files stay in place. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edits of %1 were not discarded. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RecoveryParts</name>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the model again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the earlier history</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RecoveryStrip</name>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The workbench ended unexpectedly at %1 with changes of %2 that were not saved (edits: %3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restoring…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further ones: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the last state of the model; every edit can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the model as its file has it; the edits stay in the history of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask again when you open this model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReferenceBar</name>
    <message>
        <source>Which curve the references are compared with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the curve that the references are compared with</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>no range in common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS %1 · largest %2 at %3 · over %4</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::Rehearsal</name>
    <message>
        <source>The screens ended the session before the nurse was done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has happened for fifteen minutes on the screen &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RehearseStart</name>
    <message>
        <source>No session can begin: %1 is open for reading only, because %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ReportParts</name>
    <message>
        <source>The report is written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report was not written. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the repor&amp;t of the study…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleCellBar</name>
    <message>
        <source>Enabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the selected rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected rule is enabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a cell to answer it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conflict with a rule for %1. Choose an answer to resolve it. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleEditor</name>
    <message>
        <source>Whose rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input of the columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grids or list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All rules (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the expert whose rules are edited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the input that the grids cross with each other one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleFlow</name>
    <message>
        <source>No rule of %1 fires here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1: %2 THEN %3 is %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules that act here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to select it, double-click to edit it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, as above</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleForm</name>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consequent of the rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then %1 is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rewrite rule %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added as rule %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The problem with the rule</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleGridPane</name>
    <message>
        <source>1–%1 answer and go on · Space skips · Del empties · arrows move · bar: how strongly it acts here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleGrids</name>
    <message>
        <source>Rules as grids of force words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1: %2 THEN %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, weight %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; acts here with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A grid needs two inputs. The rules of this model are in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; conflicts with a rule for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go where it acts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where does this come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleListDelegate</name>
    <message>
        <source>Consequent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleListModel</name>
    <message>
        <source>and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule %1: IF %2 THEN %3 is %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> AND </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firing strength at the place that is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. Another rule with these conditions has a different consequent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enabled: a disabled rule has no effect</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RuleListPane</name>
    <message>
        <source>Add rule…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter: well stomach, or if … and … then …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by words of the rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acting here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conflicts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which rules are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.000</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s)</source>
        <translation>
            <numerusform>%n rule</numerusform>
            <numerusform>%n rules</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go where it acts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select several rules with Ctrl or Shift: an edit changes all of them · 1–9 answer · Ctrl+C and Ctrl+V copy and paste them as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste rules from text</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RulePanel</name>
    <message>
        <source>Whose rules are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n expert(s) speak · mean %2</source>
        <translation>
            <numerusform>%1 of %n expert speaks · mean %2</numerusform>
            <numerusform>%1 of %n experts speak · mean %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n rule(s) act · %2</source>
        <translation>
            <numerusform>%1 of %n rule acts · %2</numerusform>
            <numerusform>%1 of %n rules act · %2</numerusform>
        </translation>
    </message>
    <message>
        <source>sets of %1 that the experts&apos; rules make, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sets of %1 that the rules of %2 make, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the selected rule in the rule editor (Enter, or a double click on it)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit rule %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::RulesLab</name>
    <message>
        <source>skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>between the experts %1 (SD), at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each expert says, and what it costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures of agreement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usability (Table 3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experts in the chosen cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usability scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Published: nine clinical teachers (Table 3); no nine answers give its third line as printed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No cell is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a cell of the grids. A double click on an expert&apos;s word corrects it; the old one stays in the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This study has no usability forms yet. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings about the rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at the rules…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is odd in the rules.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (in no single cell)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SearchParts</name>
    <message>
        <source>&amp;Search…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert: rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Term of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place: why this force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SessionProxy</name>
    <message>
        <source>No study is open, so no session can begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no session for this.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SessionRun</name>
    <message>
        <source>No session has begun: the study was closed while the device was looked for.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ShortcutSheet</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the operating point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click or drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers and sliders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page up, page down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept a typed number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule grids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer and go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 to 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip a cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty a cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose from a menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Membership functions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a vertex, an edge or a term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag, or its slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine step, coarse step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left, right; with Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up, down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While a model is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left, right; with Shift farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No force, at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, or put behind another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag the title or tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out of the window, or back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float, close, reset the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the zoomed part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F12, or Esc outside a drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double click the title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right button on the title</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SilenceMarks</name>
    <message>
        <source>others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no rule fires</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SpeedLab</name>
    <message>
        <source>Comparing clusters and levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing strokes again for the intervals</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SpeedLabView</name>
    <message>
        <source>Clusters and terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table 1 and warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no accepted strokes in this study. The speed has its default terms; the speed experiment begins in Collect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SpeedSettingsPanel</name>
    <message>
        <source>Clusters c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has one term for each cluster: another number shows clusters alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fuzziness m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exponent m of Eq. 1: near 1 the clusters are crisp; above 5 the centers stick to samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp end α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The membership at the ends of a ramp. 1: center points have membership 1, as the paper says, and medium is a triangle. 0.95: the ramp fits the membership best.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trimming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples below this share of their stroke&apos;s peak speed are left out: the start and the stop of each stroke.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clusters of all samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>means of the levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centers of the terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weighted mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average over the participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With %1 clusters there are no terms: the model has three, Slow, Medium and Fast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These settings make the model of all labs, and are stored in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to &amp;defaults</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SpeedTable</name>
    <message>
        <source>%1 (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the samples whose cluster is that of the level asked for. Warns below 0.6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agreement of clusters and levels beyond chance; 1 is perfect. Warns below 0.3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference of neighboring levels in standard deviations. Warns below 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the means of the strokes rise with the level: Jonckheere-Terpstra, one-sided.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fuzzy silhouette: near 1 the clusters are apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Xie-Beni index: smaller is better.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at a row to read its warnings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rand
index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Separation
d′</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trend
p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Xie-Beni</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
mean (SD)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SpeedTermPlot</name>
    <message>
        <source>Speed terms of each participant and their average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % interval of a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: where does this corner come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StartParts</name>
    <message>
        <source>The tables were not imported. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new model without rules: answer what force the experts feel in each situation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder with the tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a study of the tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies (*.tactus)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the demo study</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StartView</name>
    <message>
        <source>From what nurses know by feel to a force that a simulator can run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore the demo study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the demo study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the five-minute tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the force comes from, how to change it and how it feels, on the demo study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For researchers, nurses and simulator teams. F1 opens it anywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a fresh copy of the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copy before stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask nurses: protocol, sessions, answers and models in one file (.tactus).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New model from the NGT template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs and terms of the nasogastric tube; you give the rules.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import tables…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speeds, judgements, answers or rules as CSV, from a folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a model of another program…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FLL, FCL or FIS: fuzzylite, MATLAB, Octave, R.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study or a model. You can also drop the file here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your copy, in the folder %1 of your documents.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four simulated nurses and the model made from their answers: a copy, in the folder %1 of your documents.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StatisticHelp</name>
    <message>
        <source>Explain these numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What these numbers mean</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StrokeInfluence</name>
    <message>
        <source>%1: building the model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: comparing the force with and without it…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StrokePage</name>
    <message>
        <source>Strokes that are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 strokes of all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All levels of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stroke %1 of %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marks of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 counted again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a stroke to see what it moves. Drag a mark to correct where a stroke begins or ends; right-click a stroke to leave it out. A correction is a new record: the old one stays in the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 of %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyConnection</name>
    <message>
        <source>The erasure is not finished: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The erasure is finished: nothing of those who withdrew is left in %1. Backups and exports made before can still hold their data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has to be written first: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a newer version of Tactus wrote it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it or its folder is read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No copy of the study was kept at this opening: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyHome</name>
    <message>
        <source>&amp;Add participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tart a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Withdraw…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the protocol first: forces, questions, languages and the consent text. Then add participants, or start a session: who is new gets a code of two words on the screen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the protocol…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the first participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the data first: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no protocol yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>protocol version %1, a draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
    <message>
        <source>Con&amp;tinue with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tart with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is simulated: a program gave all of these answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the next step is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: everything is done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new participant has the code %1. Write it down and hand it over: it is the only way back to the answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No research key is set. Anybody can leave the participant&apos;s screens and read the answers of the others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a key…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a participant to continue, or start a session for a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study is open for reading only, because %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No participants yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the &amp;protocol…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill in the &amp;usability form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask a clinical teacher who tried the model six questions, with a code of their own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 moved a device that gives no force: what was judged there does not count. Start again with a device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No protocol is set. Before a person takes part, it must say whose study it is and whom to ask.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyModels</name>
    <message>
        <source>A copy was written to %1; edits go on into %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Not stored in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving in %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a model of %2 now, with everything that was done to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stored in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds answers, but no model yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds neither a model nor answers of experts. Sessions begin in Collect; or open a model and put it into the study with Study, or read tables into it with tactus study import.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model in %1 was not opened. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build the averaged model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No model was built. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 It is the model that is open already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 What was open before stays in the history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyNoticeStrip</name>
    <message>
        <source>Erasing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish the erasure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the file of the study anew, without what was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message; the menu Study shows it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyOrders</name>
    <message>
        <source>Not stored, and tried again every few seconds: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::StudyParts</name>
    <message>
        <source>&amp;New study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the study&apos;s &amp;model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Put the open model into the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Build the averaged model from the answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies (*.tactus)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last changes are not stored in %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A copy of the study was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is open for reading only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is open for reading only, because %2. Nothing can be stored in it; a copy can be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve a copy of the study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build the averaged model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copy was not saved. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record into a study: a new one, or one that is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed: Start (F9), and what you feel is recorded into %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on in a copy…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::SurfacePanel</name>
    <message>
        <source>Drag or arrow keys turn, with Shift farther; the wheel zooms; double click or Home: standard view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A surface needs a model with two inputs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force over two inputs as a surface</source>
        <translation type="unfinished"></translation>
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
    <name>tactus::workbench::TakePartStart</name>
    <message>
        <source>No session can begin: %1 is open for reading only, because %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No session can begin. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TermController</name>
    <message>
        <source>%1: no term holds %2 in full, so none can make room there. Choose a place inside a term, or switch off that the terms sum to one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TermSliders</name>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the %1 from %2: drag, or use the arrow keys, with Shift farther</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TermTable</name>
    <message>
        <source>Trapezoid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms as numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id in the model: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split or remove the term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Split…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the term into parts; its rules are copied to each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a trapezoid can be split: convert the term first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock the %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock the %1 in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the %1: type a value, or use the arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;hape</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TourCard</name>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TraceRow</name>
    <message>
        <source>Strokes of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No strokes at this level.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the recordings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave stroke %1 out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Count stroke %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1: counts from %2 s to %3 s of its recording. Drag a mark to correct it; right-click to leave the stroke out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected; the earlier record is still in the file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TubePad</name>
    <message>
        <source>Hand on the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed: the recording begins with Start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, hold the button, push right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recorded hand moves the tube.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press once, push the device away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the device, push it away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push right; click or Space lets go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or Space, then push right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go, go back left, push again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold mouse or Space, push right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::TubePicture</name>
    <message>
        <source>The tube in nose, throat and esophagus, from the side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::UsabilityTable</name>
    <message>
        <source>Statement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean (SD)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Published</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Published range</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::VariantTable</name>
    <message>
        <source>Instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::ViewMenu</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the s&amp;ystem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the next p&amp;art of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the part &amp;before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::VoteTable</name>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Winner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Votes for each force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where does this come from?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::WeightTable</name>
    <message>
        <source>Double-click a weight to change it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest change in just-noticeable differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the averaged force moves without this expert.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out, rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::WithdrawalDialog</name>
    <message>
        <source>&amp;Keep the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw and &amp;delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw a participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw %1 from the study?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything of this participant is deleted for good. This cannot be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the code %1 to confirm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code of the participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing but the code is stored of this participant. It is deleted for good.</source>
        <translation type="unfinished"></translation>
    </message>
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
    <message>
        <source>Backups and exports made before can still hold the data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deleting…</source>
        <translation type="unfinished"></translation>
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
<context>
    <name>tactus::workbench::WordBar</name>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the answer (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tactus::workbench::WordButton</name>
    <message>
        <source>Answer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer %1 (key %2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
