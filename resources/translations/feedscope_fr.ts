<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>ActionTable</name>
    <message>
        <source>Menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CauseStrip</name>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of the visible time, %3 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChartHeader</name>
    <message>
        <source>%1, %2 [%3]
Click: hide or show. Ctrl+click: only this one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChartsPanel</name>
    <message>
        <source>over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over path length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What runs along the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole run (double click in a chart)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path length [mm]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ComparisonChart</name>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycle time by limiting cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>programmed time %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>path length %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DiagnosticsView</name>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KeyList</name>
    <message>
        <source>Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;3D view:&lt;/b&gt; left drag turns, Shift or middle drag moves, wheel or right drag zooms, a click points.&lt;br&gt;&lt;b&gt;Charts:&lt;/b&gt; wheel zooms at the pointer, drag pans, a click points, a double click shows all.&lt;br&gt;&lt;b&gt;Program:&lt;/b&gt; a click on a line points at it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KinematicChart</name>
    <message>
        <source>Click: cursor. Shift+click: second cursor, differences. Wheel: zoom. Drag: pan.
Right drag or Ctrl+drag: zoom to a box. Ctrl+wheel: zoom the values. Double click: show all.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Feedscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine and control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – Feedscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
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
        <source>&amp;Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop reading or simulating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the s&amp;tart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open program …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an NC program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reload program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the program again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload when the file &amp;changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the program again whenever its file is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;machine file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use a machine of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save machine as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the machine with all changes to a machine file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave Feedscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program has been opened yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget these files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit &amp;path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole path in the 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit &amp;charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole run in the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Default layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light or dark colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes with the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a command …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys, and what the mouse does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open NC program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open machine file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save machine as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; &amp;nbsp; %2 · %3 · %4 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlaybackBar</name>
    <message>
        <source>Time within the cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playback speed; 1 is true time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Block b&amp;ack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start of this or the previous block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Block &amp;on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start of the next block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One interpolation period back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample o&amp;n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One interpolation period on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play twice as fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play half as fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play what the charts show over and over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProgramMargin</name>
    <message>
        <source>Line %1 takes no time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProgramView</name>
    <message>
        <source>Program text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text of the NC program with the time of every line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an NC program (Ctrl+O), or drop one here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is empty.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunList</name>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duplicate run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour of run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>show run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hide run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunTable</name>
    <message>
        <source>Its contour error of %1 µm is above the bound of %2 µm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>★ The fastest of these runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower [%]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed [mm/min]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the run; the box shows its path and feed beside those of the current run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine whose axis limits hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour tolerance [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle time [s, or min:s]; the star marks the fastest run that keeps the error bound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle time above that of the fastest run [%]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean feed: executed path over cycle time without dwells [mm/min]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of a programmed corner from the executed path [µm]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunsView</name>
    <message>
        <source>Error at &amp;most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs and their results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only runs whose contour error keeps this bound [µm] compete for the fastest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A copy of the current run, to be changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tolerances …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies of the current run with other contour tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the current run away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the current run up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the current run down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the current run in charts and 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model of this run reads no contour tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs with other tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour tolerances [mm], with spaces between them:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs with other tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the run and change a value to compare.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs are simulated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No run keeps this bound.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fastest: %1 with %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SettingsTable</name>
    <message>
        <source>Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SetupBar</name>
    <message>
        <source>Setup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine whose axis limits and control settings hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control model: how the control turns the path into motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour tolerance: how far the path may leave the programmed corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M&amp;odel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SetupEdit</name>
    <message>
        <source>machine %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to the machine file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SetupTable</name>
    <message>
        <source>choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed; the file says %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: the model&apos;s own value; the machine&apos;s file gives none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assumed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SetupView</name>
    <message>
        <source>Axis limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Changed against the file:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a value to see what it means. Bold: changed. Italic: assumed, no source gives it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This model reads no control settings.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulationJob</name>
    <message>
        <source>The program needs more memory than there is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatusPanel</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the simulation (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what the reader found in the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cause: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cause: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm/min</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>%1 has changed and is read again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (run %1 of %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating %1 of %2 blocks%3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>feedscope::ui</name>
    <message>
        <source>tangential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm/min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>achieved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>programmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>programmed time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycle time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 % of the cycle time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run %1 times, %2 each on average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean feed %1 mm/min</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>texts</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
