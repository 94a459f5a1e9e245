<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>Annotations</name>
    <message>
        <source>programmed feed</source>
        <translation>avance programmée</translation>
    </message>
    <message>
        <source>contour error</source>
        <translation>erreur de contour</translation>
    </message>
    <message>
        <source>limiting cause</source>
        <translation>cause limitante</translation>
    </message>
    <message>
        <source>time between the two places</source>
        <translation>temps entre les deux endroits</translation>
    </message>
    <message>
        <source>name of the run</source>
        <translation>nom de la simulation</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flèche</translation>
    </message>
    <message>
        <source>Callout</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>straight-line distance between the two places</source>
        <translation>distance en ligne droite entre les deux endroits</translation>
    </message>
</context>
<context>
    <name>ChartExport</name>
    <message>
        <source>cannot write %1: %2</source>
        <translation>impossible d’écrire %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>a row every %1 s gives more than 20 million rows; show a shorter range or choose a larger step</source>
        <translation>une ligne toutes les %1&#xa0;s ferait plus de 20 millions de lignes&#xa0;; afficher une plage plus courte, ou choisir un pas plus grand</translation>
    </message>
</context>
<context>
    <name>CircularTexts</name>
    <message>
        <source>The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by arcs about one centre. Circles of short lines are not recognised.</source>
        <translation>Le programme ne contient aucun cercle complet : aucune passe ne fait un tour entier en XY, ZX ou YZ par des arcs de même centre. Les cercles en petits segments ne sont pas reconnus.</translation>
    </message>
    <message>
        <source>The program has %1 full circles; the first %2 are evaluated.</source>
        <translation>Le programme contient %1 cercles complets ; les %2 premiers sont évalués.</translation>
    </message>
    <message>
        <source>Not evaluated: helices with full turns, %1.</source>
        <translation>Non évaluées : hélices à tours complets, %1.</translation>
    </message>
    <message>
        <source>Not evaluated: full circles outside the planes XY, ZX and YZ, %1.</source>
        <translation>Non évalués : cercles complets hors des plans XY, ZX et YZ, %1.</translation>
    </message>
    <message>
        <source>Actual path of the axes.</source>
        <translation>Trajectoire réelle des axes.</translation>
    </message>
    <message>
        <source>%1 radii and %2 feeds are %3 tests; a table has at most %4. Type fewer.</source>
        <translation>%1 rayons et %2 avances font %3 essais ; un tableau en contient au plus %4. Saisissez-en moins.</translation>
    </message>
    <message>
        <source>Set path: this machine has no drives. Give them in Machine, Drives.</source>
        <translation>Trajectoire de consigne : cette machine n’a pas d’entraînements. Donnez-les dans Machine, Entraînements.</translation>
    </message>
    <message>
        <source>Circular test (ISO 230-4)</source>
        <translation>Essai circulaire (ISO 230-4)</translation>
    </message>
    <message>
        <source>%1, model %2, %3</source>
        <translation>%1, modèle %2, %3</translation>
    </message>
    <message>
        <source>actual path of the axes</source>
        <translation>trajectoire réelle des axes</translation>
    </message>
    <message>
        <source>set path: the machine has no drives</source>
        <translation>trajectoire de consigne : la machine n’a pas d’entraînements</translation>
    </message>
</context>
<context>
    <name>Contour</name>
    <message>
        <source>inside</source>
        <translation>intérieur</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>extérieur</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>Corner of %1°, %2</source>
        <translation>Angle de %1°, %2</translation>
    </message>
    <message>
        <source>The programmed path is followed exactly: no contour error.</source>
        <translation>La trajectoire programmée est suivie exactement&#xa0;: aucune erreur de contour.</translation>
    </message>
    <message>
        <source>No contour tolerance applies.</source>
        <translation>Aucune tolérance de contour ne s’applique.</translation>
    </message>
    <message>
        <source>The largest error is along Z, so left and right do not show it.</source>
        <translation>La plus grande erreur est selon Z&#xa0;: gauche et droite ne la montrent pas.</translation>
    </message>
    <message>
        <source>The tolerances of the program, %1 to %2, are kept at all listed places.</source>
        <translation>Les tolérances du programme, de %1 à %2, sont tenues à tous les endroits de la liste.</translation>
    </message>
    <message>
        <source>The tolerances of the program, %1 to %2, are exceeded at listed places.</source>
        <translation>Les tolérances du programme, de %1 à %2, sont dépassées à des endroits de la liste.</translation>
    </message>
    <message>
        <source>The contour tolerance of %1 is kept.</source>
        <translation>La tolérance de contour de %1 est tenue.</translation>
    </message>
    <message>
        <source>The contour tolerance of %1 is exceeded by %2.</source>
        <translation>La tolérance de contour de %1 est dépassée de %2.</translation>
    </message>
    <message>
        <source>Arc R %1, %2</source>
        <translation>Arc R %1, %2</translation>
    </message>
    <message>
        <source>Line of %1</source>
        <translation>Droite de %1</translation>
    </message>
    <message>
        <source>Largest contour error %1, in line %2 at %3.</source>
        <translation>Plus grande erreur de contour %1, à la ligne %2, à %3.</translation>
    </message>
    <message>
        <source>90 % of the path is within %1, 99 % within %2.</source>
        <translation>90&#xa0;% de la trajectoire à moins de %1, 99&#xa0;% à moins de %2.</translation>
    </message>
    <message>
        <source>Rapids, which do not count here, leave the programmed path by up to %1.</source>
        <translation>Les rapides, qui ne comptent pas ici, s’écartent de la trajectoire programmée jusqu’à %1.</translation>
    </message>
    <message>
        <source>The control rounds each corner within P of G64 in the program, else within the blend tolerance of the settings.</source>
        <translation>La commande arrondit chaque angle dans P de G64 du programme, sinon dans la tolérance de raccord des réglages.</translation>
    </message>
    <message>
        <source>The control rounds each corner within the blend tolerance of the settings.</source>
        <translation>La commande arrondit chaque angle dans la tolérance de raccord des réglages.</translation>
    </message>
</context>
<context>
    <name>ContourPlot</name>
    <message>
        <source>◂ left of the path</source>
        <translation>◂ à gauche de la trajectoire</translation>
    </message>
    <message>
        <source>right of the path ▸</source>
        <translation>à droite de la trajectoire ▸</translation>
    </message>
    <message>
        <source>: %1, in XY %2</source>
        <translation>&#xa0;: %1, en XY %2</translation>
    </message>
    <message>
        <source>: %1</source>
        <translation>&#xa0;: %1</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur de trajectoire</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Erreur de contour</translation>
    </message>
    <message>
        <source>tolerance %1 ▸</source>
        <translation>tolérance %1 ▸</translation>
    </message>
    <message>
        <source>tolerance %1</source>
        <translation>tolérance %1</translation>
    </message>
</context>
<context>
    <name>Cursors</name>
    <message>
        <source>A → B:   Δt %1 s   ·   Δs %2   ·   mean feed %3   ·   Δfeed %4</source>
        <translation>A → B&#xa0;:   Δt %1&#xa0;s   ·   Δs %2   ·   avance moyenne %3   ·   Δavance %4</translation>
    </message>
</context>
<context>
    <name>DecisionTexts</name>
    <message>
        <source>actual contour error %1</source>
        <translation>erreur de contour réelle %1</translation>
    </message>
    <message>
        <source>contour error %1</source>
        <translation>erreur de contour %1</translation>
    </message>
    <message>
        <source>No run keeps a contour error of %1. The smallest is %2, with %3.</source>
        <translation>Aucune simulation ne tient une erreur de contour de %1. La plus petite est de %2, avec %3.</translation>
    </message>
    <message>
        <source>%1: %2, %3.</source>
        <translation>%1&#xa0;: %2, %3.</translation>
    </message>
    <message>
        <source>No other run keeps the bound.</source>
        <translation>Aucune autre simulation ne respecte la borne.</translation>
    </message>
    <message>
        <source>No other run with the machine&apos;s own model keeps the bound.</source>
        <translation>Aucune autre simulation avec le modèle propre à la machine ne respecte la borne.</translation>
    </message>
    <message>
        <source>No other run can be taken.</source>
        <translation>Aucune autre simulation ne peut être retenue.</translation>
    </message>
    <message>
        <source>No difference worth having: %1 takes %2, %3.</source>
        <translation>Pas de différence utile&#xa0;: %1 dure %2, %3.</translation>
    </message>
    <message>
        <source>The cycle times differ by less than 1 %. No run has a smaller error.</source>
        <translation>Les temps de cycle diffèrent de moins de 1 %. Aucune simulation n’a d’erreur plus petite.</translation>
    </message>
    <message>
        <source>%1: %2, %3 less than %4, %5.</source>
        <translation>%1&#xa0;: %2, %3 de moins que %4, %5.</translation>
    </message>
    <message>
        <source>The fastest run. None within 1 % of it has a smaller error.</source>
        <translation>La simulation la plus rapide. Aucune à moins de 1 % d’elle n’a une erreur plus petite.</translation>
    </message>
    <message>
        <source>The smallest error within 1 % of the fastest run.</source>
        <translation>La plus petite erreur à moins de 1 % de la simulation la plus rapide.</translation>
    </message>
    <message>
        <source>Runs with another model than their machine&apos;s own do not count.</source>
        <translation>Les simulations avec un autre modèle que celui de leur machine ne comptent pas.</translation>
    </message>
    <message>
        <source>No other run of the machine&apos;s own model can be taken.</source>
        <translation>Aucune autre simulation du modèle propre à la machine ne peut être retenue.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>%1, %2 less than programmed (%3); %4.</source>
        <translation>%1, %2 de moins que programmé (%3)&#xa0;; %4.</translation>
    </message>
    <message>
        <source>%1, as long as programmed; %2.</source>
        <translation>%1, comme programmé&#xa0;; %2.</translation>
    </message>
    <message>
        <source>%1, of which %2 are lost (%3); %4.</source>
        <translation>%1, dont %2 perdues (%3)&#xa0;; %4.</translation>
    </message>
    <message>
        <source>The control refuses the program in all runs.</source>
        <translation>La commande refuse le programme dans toutes les simulations.</translation>
    </message>
    <message>
        <source>No run has the model of its machine: none is recommended.</source>
        <translation>Aucune simulation n’a le modèle de sa machine&#xa0;: aucune n’est recommandée.</translation>
    </message>
    <message>
        <source>The machine cannot turn its rotary axes as the program asks in any run.</source>
        <translation>La machine ne peut tourner ses axes rotatifs comme le programme le demande dans aucune simulation.</translation>
    </message>
    <message>
        <source>No run is possible: the control refuses the program, or the machine cannot turn its rotary axes as it asks.</source>
        <translation>Aucune simulation n’est possible&#xa0;: la commande refuse le programme, ou la machine ne peut tourner ses axes rotatifs comme il le demande.</translation>
    </message>
</context>
<context>
    <name>Faults</name>
    <message>
        <source>1 error</source>
        <translation>1 erreur</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 erreurs</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 avertissement</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 avertissements</translation>
    </message>
    <message>
        <source>Program read with %1 and %2</source>
        <translation>Programme lu avec %1 et %2</translation>
    </message>
    <message>
        <source>Program read with %1</source>
        <translation>Programme lu avec %1</translation>
    </message>
</context>
<context>
    <name>FilmFrames</name>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1 : %2</translation>
    </message>
</context>
<context>
    <name>IdentificationTexts</name>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>non trouvé</translation>
    </message>
    <message>
        <source>A recording of the test program tells it: part %1.</source>
        <translation>Un enregistrement du programme d’essai le révèle&#xa0;: partie %1.</translation>
    </message>
    <message>
        <source>The model %1 explains what was recorded.</source>
        <translation>Le modèle %1 explique ce qui a été enregistré.</translation>
    </message>
    <message>
        <source>%1: %2 recorded, %3 simulated (%4 %)</source>
        <translation>%1&#xa0;: %2 enregistrés, %3 simulés (%4&#xa0;%)</translation>
    </message>
    <message>
        <source>%1; the feeds differ by %2 (rms).</source>
        <translation>%1&#xa0;; les avances diffèrent de %2 (moyenne quadratique).</translation>
    </message>
    <message>
        <source>The part %1 of the test program would show: %2</source>
        <translation>La partie %1 du programme d’essai montrerait : %2</translation>
    </message>
    <message>
        <source>With 95 % probability the true value is %1, if the control is of this model.</source>
        <translation>Avec une probabilité de 95&#xa0;%, la vraie valeur est %1, si la commande suit ce modèle.</translation>
    </message>
    <message>
        <source>Found: %1 of %2 values.</source>
        <translation>Trouvées&#xa0;: %1 valeurs sur %2.</translation>
    </message>
    <message>
        <source>The others keep the value that explains the recording as well.</source>
        <translation>Les autres gardent la valeur qui explique aussi bien l’enregistrement.</translation>
    </message>
    <message>
        <source>The model %1 does not explain what was recorded: it misses more than 5 % of the feed or 1 % of the time, so its numbers would say nothing of your machine.</source>
        <translation>Le modèle %1 n’explique pas ce qui a été enregistré&#xa0;: il manque plus de 5&#xa0;% de l’avance ou 1&#xa0;% du temps, ses nombres ne diraient donc rien de votre machine.</translation>
    </message>
    <message>
        <source>With 95 % probability the true value is %1, if the drive is linear and both positions are of the same instant.</source>
        <translation>Avec une probabilité de 95 %, la vraie valeur est %1, si l’entraînement est linéaire et les deux positions du même instant.</translation>
    </message>
    <message>
        <source>Drive of %1: not found.</source>
        <translation>Entraînement de %1&#xa0;: non trouvé.</translation>
    </message>
    <message>
        <source>Drive of %1: following error %2 (rms), %3 of it unexplained</source>
        <translation>Entraînement de %1&#xa0;: écart de poursuite %2 (moyenne quadratique), dont %3 inexpliqué</translation>
    </message>
    <message>
        <source>%1: too much to find its values.</source>
        <translation>%1&#xa0;: trop pour trouver ses valeurs.</translation>
    </message>
    <message>
        <source>Drive of %1: not found, the actual positions seem to be %2 ms later than the set ones.</source>
        <translation>Entraînement de %1&#xa0;: non trouvé, les positions réelles semblent suivre les consignes de %2 ms.</translation>
    </message>
    <message>
        <source>No part of the test program would show this value.</source>
        <translation>Aucune partie du programme d’essai ne montrerait cette valeur.</translation>
    </message>
    <message>
        <source>Not looked for: %1. With these the model may explain it.</source>
        <translation>Non cherchés&#xa0;: %1. Avec eux, le modèle pourrait l’expliquer.</translation>
    </message>
    <message>
        <source>In use: %1.</source>
        <translation>Valeur utilisée&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>KinematicCharts</name>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>Écart de poursuite</translation>
    </message>
    <message>
        <source>Cutting force</source>
        <translation>Effort de coupe</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Épaisseur de copeau</translation>
    </message>
    <message>
        <source>Position of rotary axes</source>
        <translation>Position des axes rotatifs</translation>
    </message>
    <message>
        <source>Velocity of rotary axes</source>
        <translation>Vitesse des axes rotatifs</translation>
    </message>
    <message>
        <source>Acceleration of rotary axes</source>
        <translation>Accélération des axes rotatifs</translation>
    </message>
    <message>
        <source>Jerk of rotary axes</source>
        <translation>Jerk des axes rotatifs</translation>
    </message>
</context>
<context>
    <name>KinematicsPicture</name>
    <message>
        <source>turns without end</source>
        <translation>tourne sans fin</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>no end</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>All axes at zero; lengths in mm; arrows: positive directions of the tool against the part (ISO 841)</source>
        <translation>Tous les axes à zéro&#xa0;; longueurs en mm&#xa0;; flèches&#xa0;: sens positifs de l’outil par rapport à la pièce (ISO 841)</translation>
    </message>
    <message>
        <source>gauge point (0, 0, 0)</source>
        <translation>point de référence (0&#xa0;; 0&#xa0;; 0)</translation>
    </message>
    <message>
        <source>tool, %1 mm</source>
        <translation>outil, %1&#xa0;mm</translation>
    </message>
    <message>
        <source>tool, length not given</source>
        <translation>outil, longueur non donnée</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1&#xa0;; %2&#xa0;; %3)</translation>
    </message>
    <message>
        <source>%1 rev/min</source>
        <translation>%1&#xa0;tr/min</translation>
    </message>
    <message>
        <source>through %1</source>
        <translation>par %1</translation>
    </message>
    <message>
        <source>turns the part</source>
        <translation>tourne la pièce</translation>
    </message>
    <message>
        <source>turns the tool</source>
        <translation>tourne l’outil</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>bâti</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>outil</translation>
    </message>
    <message>
        <source>Chain: axes before the frame carry the part, those behind it the tool</source>
        <translation>Chaîne&#xa0;: les axes avant le bâti portent la pièce, ceux qui le suivent l’outil</translation>
    </message>
</context>
<context>
    <name>LensPicture</name>
    <message>
        <source>across × %1</source>
        <translation>en travers × %1</translation>
    </message>
    <message>
        <source>no deviation</source>
        <translation>aucun écart</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>l. %1</translation>
    </message>
    <message>
        <source>Lens: line %1</source>
        <translation>Loupe : ligne %1</translation>
    </message>
    <message>
        <source>%1 along</source>
        <translation>%1 en long</translation>
    </message>
    <message>
        <source>%1 across</source>
        <translation>%1 en travers</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>avance</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>erreur max.</translation>
    </message>
</context>
<context>
    <name>LimitLines</name>
    <message>
        <source>limit of %1</source>
        <translation>limite de %1</translation>
    </message>
    <message>
        <source>least chip</source>
        <translation>copeau minimal</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>borne</translation>
    </message>
</context>
<context>
    <name>LineFinder</name>
    <message>
        <source>At character %1: %2</source>
        <translation>Au caractère %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>LineTimeText</name>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation>Lignes %1 à %2</translation>
    </message>
    <message>
        <source>%1, %2 % of the cycle time</source>
        <translation>%1, %2&#xa0;% du temps de cycle</translation>
    </message>
    <message>
        <source>executed %1 times, %2 each on average</source>
        <translation>exécutée %1 fois, %2 chacune en moyenne</translation>
    </message>
    <message>
        <source>mean feed %1</source>
        <translation>avance moyenne %1</translation>
    </message>
</context>
<context>
    <name>Load</name>
    <message>
        <source>all tools</source>
        <translation>tous les outils</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>outil %1</translation>
    </message>
    <message>
        <source>%1, lines %2</source>
        <translation>%1, lignes %2</translation>
    </message>
    <message>
        <source>%1 of feed motions without an operation</source>
        <translation>%1 de déplacements d’usinage sans opération</translation>
    </message>
    <message>
        <source>%1 of plunging and drilling, which is not modelled</source>
        <translation>%1 de plongée et de perçage, non modélisés</translation>
    </message>
    <message>
        <source>%1 with a spindle that stands or whose speed is not known</source>
        <translation>%1 avec une broche arrêtée ou de vitesse inconnue</translation>
    </message>
    <message>
        <source>No load for %1.</source>
        <translation>Pas de charge pour %1.</translation>
    </message>
    <message>
        <source>Load over %1 of cutting; %2.</source>
        <translation>Charge sur %1 de coupe&#xa0;; %2.</translation>
    </message>
    <message>
        <source>%1: nowhere</source>
        <translation>%1&#xa0;: nulle part</translation>
    </message>
    <message>
        <source>one place</source>
        <translation>un endroit</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 endroits</translation>
    </message>
    <message>
        <source>%1: %2 in %3, %4 at the programmed feed</source>
        <translation>%1&#xa0;: %2 en %3, %4 à l’avance programmée</translation>
    </message>
</context>
<context>
    <name>NumberText</name>
    <message>
        <source>“%1” is not a number.</source>
        <translation>« %1 » n’est pas un nombre.</translation>
    </message>
    <message>
        <source>“%1” could be %2 or %3; type one of these.</source>
        <translation>« %1 » pourrait être %2 ou %3 ; saisissez l’un des deux.</translation>
    </message>
    <message>
        <source>“%1” has more than one decimal separator or uses thousands separators; type %2.</source>
        <translation>«&#xa0;%1&#xa0;» a plus d’un séparateur décimal ou des séparateurs de milliers&#xa0;; saisissez %2.</translation>
    </message>
    <message>
        <source>“%1” has more than one decimal separator; type one number.</source>
        <translation>«&#xa0;%1&#xa0;» a plus d’un séparateur décimal&#xa0;; saisissez un seul nombre.</translation>
    </message>
</context>
<context>
    <name>OperationTitles</name>
    <message>
        <source>Before the first tool</source>
        <translation>Avant le premier outil</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Outil %1</translation>
    </message>
    <message>
        <source>Before the first comment</source>
        <translation>Avant le premier commentaire</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
</context>
<context>
    <name>PageWords</name>
    <message>
        <source>%1 lost here</source>
        <translation>%1 perdus ici</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 endroits</translation>
    </message>
    <message>
        <source>%1: %2 of %3 (%4).</source>
        <translation>%1&#xa0;: %2 sur %3 (%4).</translation>
    </message>
    <message>
        <source>%1: the axes stand.</source>
        <translation>%1&#xa0;: les axes sont à l’arrêt.</translation>
    </message>
    <message>
        <source>About this page</source>
        <translation>À propos de cette page</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Par rapport à</translation>
    </message>
    <message>
        <source>All data is in this file; it asks no other one and no network.</source>
        <translation>Toutes les données sont dans ce fichier&#xa0;; il n’en demande pas d’autre et n’utilise pas le réseau.</translation>
    </message>
    <message>
        <source>Charts over</source>
        <translation>Graphiques selon</translation>
    </message>
    <message>
        <source>Drag: turn. Right button or two fingers: move. Wheel or pinch: zoom. Double click: fit. In charts drag to move, wheel or pinch to zoom. Space plays, N and P go to the next and previous worst place, F fits, arrows move the cursor.</source>
        <translation>Glisser&#xa0;: tourner. Bouton droit ou deux doigts&#xa0;: déplacer. Molette ou pincement&#xa0;: agrandir. Double clic&#xa0;: ajuster. Dans les graphiques, glisser déplace, molette ou pincement agrandit. Espace lit, N et P vont au pire endroit suivant et précédent, F ajuste, les flèches déplacent le curseur.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Fit the path into the picture (F)</source>
        <translation>Ajuster la trajectoire à l’image (F)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Go to the report below</source>
        <translation>Aller au rapport plus bas</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Loupe</translation>
    </message>
    <message>
        <source>Long program, drawn coarser away from the listed places: path within %1, feed within %2 of the largest</source>
        <translation>Programme long, tracé plus grossier hors des endroits listés&#xa0;: trajectoire à %1 près, avance à %2 de la plus grande</translation>
    </message>
    <message>
        <source>Look from here</source>
        <translation>Regarder d’ici</translation>
    </message>
    <message>
        <source>Made with Feedscope %1. Simulated, not measured.</source>
        <translation>Fait avec Feedscope %1. Simulé, non mesuré.</translation>
    </message>
    <message>
        <source>Max. error</source>
        <translation>Erreur max.</translation>
    </message>
    <message>
        <source>Next worst place</source>
        <translation>Pire endroit suivant</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Path within %1, feed within %2 of the largest</source>
        <translation>Trajectoire à %1 près, avance à %2 de la plus grande</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Previous worst place</source>
        <translation>Pire endroit précédent</translation>
    </message>
    <message>
        <source>Programmed</source>
        <translation>Programmé</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Rapides</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Show rapids</source>
        <translation>Montrer les rapides</translation>
    </message>
    <message>
        <source>Show the lens (L)</source>
        <translation>Montrer la loupe (L)</translation>
    </message>
    <message>
        <source>Show the programmed path</source>
        <translation>Montrer la trajectoire programmée</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>This browser draws no 3D (WebGL 2): a picture of the report.</source>
        <translation>Ce navigateur ne trace pas de 3D (WebGL 2)&#xa0;: une image du rapport.</translation>
    </message>
    <message>
        <source>Time lost</source>
        <translation>Temps perdu</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>against %1</source>
        <translation>par rapport à %1</translation>
    </message>
    <message>
        <source>no bound</source>
        <translation>sans borne</translation>
    </message>
    <message>
        <source>over path</source>
        <translation>selon la trajectoire</translation>
    </message>
    <message>
        <source>over time</source>
        <translation>selon le temps</translation>
    </message>
    <message>
        <source>place %1 of %2</source>
        <translation>endroit %1 sur %2</translation>
    </message>
    <message>
        <source>rotary axes within %1 of their limits</source>
        <translation>axes rotatifs à %1 de leurs limites près</translation>
    </message>
</context>
<context>
    <name>PictureCaption</name>
    <message>
        <source>run</source>
        <translation>simulation</translation>
    </message>
    <message>
        <source>colour: %1</source>
        <translation>couleur&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1, pink the place</source>
        <translation>%1, en rose l’endroit</translation>
    </message>
    <message>
        <source>Place %1, line %2</source>
        <translation>Endroit %1, ligne %2</translation>
    </message>
</context>
<context>
    <name>ReportParts</name>
    <message>
        <source>Annotations</source>
        <translation>Annotations</translation>
    </message>
    <message>
        <source>What would help (simulated)</source>
        <translation>Quels remèdes (simulés)</translation>
    </message>
    <message>
        <source>Places that lose most, with close-ups</source>
        <translation>Endroits qui perdent le plus, en gros plan</translation>
    </message>
    <message>
        <source>Cutting load</source>
        <translation>Charge de coupe</translation>
    </message>
    <message>
        <source>Agreement with the control</source>
        <translation>Accord avec la commande</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Machine, settings, models, trust</source>
        <translation>Machine, réglages, modèles, confiance</translation>
    </message>
    <message>
        <source>Appendix: figures of the runs</source>
        <translation>Annexe&#xa0;: chiffres des simulations</translation>
    </message>
    <message>
        <source>Appendix: where does the time go?</source>
        <translation>Annexe&#xa0;: où passe le temps</translation>
    </message>
    <message>
        <source>Appendix: time by limiting cause</source>
        <translation>Annexe&#xa0;: temps par cause limitante</translation>
    </message>
    <message>
        <source>Appendix: settings that differ</source>
        <translation>Annexe&#xa0;: réglages qui diffèrent</translation>
    </message>
    <message>
        <source>Appendix: axes against their limits</source>
        <translation>Annexe&#xa0;: axes par rapport à leurs limites</translation>
    </message>
    <message>
        <source>Appendix: charts</source>
        <translation>Annexe&#xa0;: graphiques</translation>
    </message>
    <message>
        <source>Appendix: table of slow places</source>
        <translation>Annexe&#xa0;: tableau des endroits lents</translation>
    </message>
    <message>
        <source>Appendix: contour error</source>
        <translation>Annexe&#xa0;: erreur de contour</translation>
    </message>
    <message>
        <source>Appendix: circular test</source>
        <translation>Annexe&#xa0;: essai circulaire</translation>
    </message>
    <message>
        <source>Appendix: program</source>
        <translation>Annexe&#xa0;: programme</translation>
    </message>
    <message>
        <source>Appendix: machine with sources</source>
        <translation>Annexe&#xa0;: machine avec ses sources</translation>
    </message>
    <message>
        <source>Appendix: all settings</source>
        <translation>Annexe&#xa0;: tous les réglages</translation>
    </message>
    <message>
        <source>Appendix: control models</source>
        <translation>Annexe&#xa0;: modèles de commande</translation>
    </message>
</context>
<context>
    <name>ReportWords</name>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 sur %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Centre X, Y, Z</source>
        <translation>Centre X, Y, Z</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>F&lt;sub&gt;max&lt;/sub&gt;</source>
        <translation>F&lt;sub&gt;max&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>F&lt;sub&gt;min&lt;/sub&gt;</source>
        <translation>F&lt;sub&gt;min&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>F&lt;sub&gt;mean&lt;/sub&gt;</source>
        <translation>F&lt;sub&gt;moy&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>The first %1 of %2 circles; “feedscope circular” lists all of them.</source>
        <translation>Les %1 premiers cercles sur %L2&#xa0;; «&#xa0;feedscope circular&#xa0;» les liste tous.</translation>
    </message>
    <message>
        <source>G: circular error, least radial separation of two concentric circles that hold the path; G&lt;sub&gt;ls&lt;/sub&gt;: the same about the centre of the least-squares circle; F&lt;sub&gt;max&lt;/sub&gt;, F&lt;sub&gt;min&lt;/sub&gt;, F&lt;sub&gt;mean&lt;/sub&gt;: largest, least and mean deviation from the programmed radius at the programmed centre; G(b), D: circular error of both directions together, and their mean radius less the programmed one, where the same circle is run in both at one feed. Centre and radius are those of the tool centre; ccw, cw: counter-clockwise, clockwise in the plane.</source>
        <translation>G&#xa0;: écart circulaire, plus petite distance radiale entre deux cercles concentriques qui contiennent la trajectoire&#xa0;; G&lt;sub&gt;ls&lt;/sub&gt;&#xa0;: le même, autour du centre du cercle des moindres carrés&#xa0;; F&lt;sub&gt;max&lt;/sub&gt;, F&lt;sub&gt;min&lt;/sub&gt;, F&lt;sub&gt;moy&lt;/sub&gt;&#xa0;: écart maximal, minimal et moyen au rayon programmé, depuis le centre programmé&#xa0;; G(b), D&#xa0;: écart circulaire des deux sens réunis, et leur rayon moyen moins le rayon programmé, là où le même cercle est parcouru dans les deux sens à la même avance. Centre et rayon sont ceux du centre de l’outil&#xa0;; trig., hor.&#xa0;: sens trigonométrique, horaire dans le plan.</translation>
    </message>
    <message>
        <source>Circular test (ISO 230-4)</source>
        <translation>Essai circulaire (ISO 230-4)</translation>
    </message>
    <message>
        <source>%1, model %2</source>
        <translation>%1, modèle %2</translation>
    </message>
    <message>
        <source>the first %1 of %2 circles</source>
        <translation>des %1 premiers cercles sur %L2</translation>
    </message>
    <message>
        <source>the circles</source>
        <translation>des cercles</translation>
    </message>
    <message>
        <source>Polar plots of the circles of the program</source>
        <translation>Diagrammes polaires des cercles du programme</translation>
    </message>
    <message>
        <source>Polar plots of %1 of %2 by the %3 path; radial deviations are enlarged.</source>
        <translation>Diagrammes polaires %1 (%2), d’après la trajectoire %3&#xa0;; les écarts radiaux sont agrandis.</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>réelle</translation>
    </message>
    <message>
        <source>set</source>
        <translation>de consigne</translation>
    </message>
    <message>
        <source>%1 and %2 similar</source>
        <translation>%1 et %L2 semblables</translation>
    </message>
    <message>
        <source>, the other runs as outlines</source>
        <translation>, les autres simulations en trait seul</translation>
    </message>
    <message>
        <source>Path length by contour error</source>
        <translation>Longueur de trajectoire par erreur de contour</translation>
    </message>
    <message>
        <source>Path length of %1 by contour error%2. %3 %4</source>
        <translation>Longueur de trajectoire par erreur de contour (%1)%2. %3 %4</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Of tolerance [%]</source>
        <translation>De la tolérance [%]</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>At X, Y, Z</source>
        <translation>En X, Y, Z</translation>
    </message>
    <message>
        <source>Place %1: line %2, %3</source>
        <translation>Endroit %1&#xa0;: ligne %2, %3</translation>
    </message>
    <message>
        <source>; deviations exaggerated %1 times</source>
        <translation>&#xa0;; écarts agrandis %1 fois</translation>
    </message>
    <message>
        <source>Close-up of contour error %1</source>
        <translation>Gros plan de l’erreur de contour %1</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dents</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>Hélice</translation>
    </message>
    <message>
        <source>Milling</source>
        <translation>Fraisage</translation>
    </message>
    <message>
        <source>Cutting time</source>
        <translation>Temps de coupe</translation>
    </message>
    <message>
        <source>up</source>
        <translation>en opposition</translation>
    </message>
    <message>
        <source>down</source>
        <translation>en avalant</translation>
    </message>
    <message>
        <source>At the predicted feed</source>
        <translation>À l’avance prévue</translation>
    </message>
    <message>
        <source>At the programmed feed</source>
        <translation>À l’avance programmée</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>in line</source>
        <translation>à la ligne</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>Beyond a bound</source>
        <translation>Au-delà d’une borne</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>pire valeur</translation>
    </message>
    <message>
        <source>from</source>
        <translation>à partir de</translation>
    </message>
    <message>
        <source>for</source>
        <translation>durée</translation>
    </message>
    <message>
        <source>The %1 longest of %2 places.</source>
        <translation>Les %1 endroits les plus longs sur %L2.</translation>
    </message>
    <message>
        <source>3D view by chip thickness</source>
        <translation>Vue 3D selon l’épaisseur de copeau</translation>
    </message>
    <message>
        <source>Chip thickness of %1 along the path; grey: no load is computed.</source>
        <translation>Épaisseur de copeau le long de la trajectoire (%1)&#xa0;; gris&#xa0;: aucune charge n’est calculée.</translation>
    </message>
    <message>
        <source>assumed: %1</source>
        <translation>hypothèse&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rotary axis</source>
        <translation>Axe rotatif</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Chain, part to tool</source>
        <translation>Chaîne, de la pièce à l’outil</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Tolerance in force</source>
        <translation>Tolérance en vigueur</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>&lt;b&gt;Reference:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Référence&#xa0;:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>Guarantees of %1</source>
        <translation>Ce qui est garanti (%1)</translation>
    </message>
    <message>
        <source>Guarantees</source>
        <translation>Ce qui est garanti</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>yyyy-MM-dd</source>
        <comment>date</comment>
        <translation>d MMMM yyyy</translation>
    </message>
    <message>
        <source>Figure %1. </source>
        <translation>Figure %1. </translation>
    </message>
    <message>
        <source>Executed path of %1; deviations exaggerated %2 times.</source>
        <translation>Trajectoire exécutée&#xa0;: %1&#xa0;; écarts agrandis %2 fois.</translation>
    </message>
    <message>
        <source>Programmed and executed path of %1.</source>
        <translation>Trajectoires programmée et exécutée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>3D view by limiting cause</source>
        <translation>Vue 3D par cause limitante</translation>
    </message>
    <message>
        <source>What limits the feed of %1 along the path.</source>
        <translation>Ce qui limite l’avance le long de la trajectoire&#xa0;: %1.</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>jerk</source>
        <translation>jerk</translation>
    </message>
    <message>
        <source>following error</source>
        <translation>écart de poursuite</translation>
    </message>
    <message>
        <source>cutting force</source>
        <translation>effort de coupe</translation>
    </message>
    <message>
        <source>chip thickness</source>
        <translation>épaisseur de copeau</translation>
    </message>
    <message>
        <source>positions of rotary axes</source>
        <translation>positions des axes rotatifs</translation>
    </message>
    <message>
        <source>their velocities</source>
        <translation>vitesses de ces axes</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Charts of %1</source>
        <translation>Graphiques&#xa0;: %1</translation>
    </message>
    <message>
        <source>Feed with its limiting causes, %1 of %2.</source>
        <translation>Avance et causes qui la limitent, %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Cycle times by limiting cause</source>
        <translation>Temps de cycle par cause limitante</translation>
    </message>
    <message>
        <source>Cycle times by limiting cause; the dashed line is the programmed time.</source>
        <translation>Temps de cycle par cause limitante&#xa0;; le trait interrompu marque le temps programmé.</translation>
    </message>
    <message>
        <source>Lost [s]</source>
        <translation>Perte [s]</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>%1 places lose %2 s against the programmed feed; the %3 listed lose %4 s of it. “Why” names what most of the time is lost to.</source>
        <translation>%L1 endroits perdent %2 s par rapport à l’avance programmée, dont %4 s pour les %3 du tableau. «&#xa0;Pourquoi&#xa0;» nomme ce qui coûte l’essentiel du temps.</translation>
    </message>
    <message>
        <source>Close-up of place %1</source>
        <translation>Gros plan de l’endroit %1</translation>
    </message>
    <message>
        <source>Place %1: lines %2, %3 s lost.</source>
        <translation>Endroit %1&#xa0;: lignes %2, perte %3 s.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Limité par</translation>
    </message>
    <message>
        <source>Most of the time of %1 is limited by: %2.</source>
        <translation>Pour %1, l’essentiel du temps est limité par&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Cycle time [s]</source>
        <translation>Temps de cycle [s]</translation>
    </message>
    <message>
        <source>× pro-&lt;br/&gt;grammed</source>
        <translation>× pro-&lt;br/&gt;grammé</translation>
    </message>
    <message>
        <source>To first [%]</source>
        <translation>Écart à la 1&lt;sup&gt;re&lt;/sup&gt; [%]</translation>
    </message>
    <message>
        <source>Mean feed</source>
        <translation>Avance moyenne</translation>
    </message>
    <message>
        <source>Peak feed</source>
        <translation>Avance maximale</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Erreur de contour</translation>
    </message>
    <message>
        <source>Corner blends</source>
        <translation>Raccords d’angle</translation>
    </message>
    <message>
        <source>of the limit</source>
        <translation>de la limite</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>sauts</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 à %2 %3</translation>
    </message>
    <message>
        <source>not programmed</source>
        <translation>non programmé</translation>
    </message>
    <message>
        <source>%1; cutting %2; rapid %3</source>
        <translation>%1&#xa0;; en avance %2&#xa0;; en rapide %3</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (ligne %2)</translation>
    </message>
    <message>
        <source>none programmed</source>
        <translation>aucun programmé</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>lines %1 to %2</source>
        <translation>lignes %1 à %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %L1 de plus</translation>
    </message>
    <message>
        <source>as the machine</source>
        <translation>comme la machine</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecte</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>%1 lines, %2 blocks run</source>
        <translation>%L1 lignes, %L2 blocs exécutés</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Éléments</translation>
    </message>
    <message>
        <source>%1: %2 lines, %3 arcs, %4 dwells</source>
        <translation>%L1&#xa0;: %L2 droites, %L3 arcs, %L4 temporisations</translation>
    </message>
    <message>
        <source>Extent of %1</source>
        <translation>Étendue en %1</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur de trajectoire</translation>
    </message>
    <message>
        <source>%1 %3, %2 %3 of it rapid</source>
        <translation>%1 %3, dont %2 %3 en rapide</translation>
    </message>
    <message>
        <source>Dwells</source>
        <translation>Temporisations</translation>
    </message>
    <message>
        <source>Programmed feeds</source>
        <translation>Avances programmées</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Chord error</source>
        <translation>Erreur de corde</translation>
    </message>
    <message>
        <source>about %1 %2, estimated from %3 short lines</source>
        <translation>environ %1 %2, estimée sur %L3 droites courtes</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Not in the cycle time</source>
        <translation>Hors temps de cycle</translation>
    </message>
    <message>
        <source>Subprogram calls</source>
        <translation>Appels de sous-programmes</translation>
    </message>
    <message>
        <source>Path control</source>
        <translation>Mode de trajectoire</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Where does the time go?</source>
        <translation>Où passe le temps&#xa0;?</translation>
    </message>
    <message>
        <source>Places that lose most, by what they have in common</source>
        <translation>Endroits qui perdent le plus, par ce qu’ils ont en commun</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Ce qui ferait gagner du temps</translation>
    </message>
    <message>
        <source>Cycle time and what limits it</source>
        <translation>Temps de cycle et ce qui le limite</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>Réglages qui diffèrent</translation>
    </message>
    <message>
        <source>Axes against their limits</source>
        <translation>Axes face à leurs limites</translation>
    </message>
    <message>
        <source>Along the path</source>
        <translation>Le long de la trajectoire</translation>
    </message>
    <message>
        <source>Where most time is lost</source>
        <translation>Où se perd le plus de temps</translation>
    </message>
    <message>
        <source>Places of %1 that are slower than programmed, the worst first.</source>
        <translation>Endroits plus lents que programmé (%1), les pires en premier.</translation>
    </message>
    <message>
        <source>Where the path deviates most</source>
        <translation>Où la trajectoire s’écarte le plus</translation>
    </message>
    <message>
        <source>Places of %1 that are farthest from the programmed path, the worst first; left and right are seen in its direction.</source>
        <translation>Endroits les plus éloignés de la trajectoire programmée (%1), les pires en premier&#xa0;; gauche et droite s’entendent dans le sens de parcours.</translation>
    </message>
    <message>
        <source>Circular test</source>
        <translation>Essai circulaire</translation>
    </message>
    <message>
        <source>Full circles of the program as %1 makes them, evaluated by ISO 230-4.</source>
        <translation>Cercles complets du programme tels que %1 les réalise, évalués selon l’ISO 230-4.</translation>
    </message>
    <message>
        <source>Cutting load</source>
        <translation>Charge de coupe</translation>
    </message>
    <message>
        <source>What %1 puts on the tools, beside what the programmed feed would.</source>
        <translation>Ce que %1 impose aux outils, à côté de ce que donnerait l’avance programmée.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Messages of the reader</source>
        <translation>Messages de lecture</translation>
    </message>
    <message>
        <source>Every number with its source; values that no source gives are assumed and in italics.</source>
        <translation>Chaque nombre avec sa source&#xa0;; les valeurs qu’aucune source ne donne sont des hypothèses, en italique.</translation>
    </message>
    <message>
        <source>Settings of the runs</source>
        <translation>Réglages des simulations</translation>
    </message>
    <message>
        <source>Control models</source>
        <translation>Modèles de commande</translation>
    </message>
    <message>
        <source>How to make this again</source>
        <translation>Pour refaire ce rapport</translation>
    </message>
    <message>
        <source>With Feedscope %1:</source>
        <translation>Avec Feedscope %1&#xa0;:</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Temps [s]</translation>
    </message>
    <message>
        <source>Share [%]</source>
        <translation>Part [%]</translation>
    </message>
    <message>
        <source>Programmed [s]</source>
        <translation>Programmé [s]</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Operation by tool</source>
        <translation>Opération, par outil</translation>
    </message>
    <message>
        <source>Operation by comment</source>
        <translation>Opération, par commentaire</translation>
    </message>
    <message>
        <source>Rapids [s]</source>
        <translation>Rapides [s]</translation>
    </message>
    <message>
        <source>Loses most to</source>
        <translation>Perd surtout par</translation>
    </message>
    <message>
        <source>The %1 operations of %2 that take longest.</source>
        <translation>Les %1 opérations les plus longues sur %L2.</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Endroits</translation>
    </message>
    <message>
        <source>In common</source>
        <translation>En commun</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Worst line</source>
        <translation>Pire ligne</translation>
    </message>
    <message>
        <source>Share: of all the time that is lost along the path against the programmed feed.</source>
        <translation>Part&#xa0;: de tout le temps perdu le long de la trajectoire par rapport à l’avance programmée.</translation>
    </message>
    <message>
        <source>None of the %1 changes that were simulated helps.</source>
        <translation>Aucun des %1 changements simulés ne fait gagner de temps.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Gain [s]</source>
        <translation>Gain [s]</translation>
    </message>
    <message>
        <source>Gain [%]</source>
        <translation>Gain [%]</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>État actuel</translation>
    </message>
    <message>
        <source>Those of this machine together</source>
        <translation>Ceux de cette machine ensemble</translation>
    </message>
    <message>
        <source>The best of %1 changes of the whole program, each simulated. Whether machine, tool and material bear it is not checked.</source>
        <translation>Les meilleurs de %1 changements du programme entier, chacun simulé. Que la machine, l’outil et la matière les supportent n’est pas vérifié.</translation>
    </message>
    <message>
        <source>cycle time</source>
        <translation>temps de cycle</translation>
    </message>
    <message>
        <source>× programmed time</source>
        <translation>× temps programmé</translation>
    </message>
    <message>
        <source>peak feed, %1</source>
        <translation>avance max., %1</translation>
    </message>
    <message>
        <source>contour error, %1</source>
        <translation>erreur de contour, %1</translation>
    </message>
    <message>
        <source>%1 blocks, path %2 %3</source>
        <translation>%L1 blocs, trajectoire de %2 %3</translation>
    </message>
    <message>
        <source>Control model</source>
        <translation>Modèle de commande</translation>
    </message>
    <message>
        <source>%1 is limited by</source>
        <translation>%1 est limité par</translation>
    </message>
    <message>
        <source>ccw</source>
        <translation>trig.</translation>
    </message>
    <message>
        <source>cw</source>
        <translation>hor.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>of an axis</comment>
        <translation>%1 de l’axe %2</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <comment>coordinates</comment>
        <translation>%1&#xa0;; %2&#xa0;; %3</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Agreement with the control</source>
        <translation>Accord avec la commande</translation>
    </message>
    <message>
        <source>What the control recorded, beside %1; the feeds of both stand in the charts along the path.</source>
        <translation>Ce que la commande a enregistré, à côté de %1&#xa0;; les avances des deux sont dans les graphiques le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Largest lean</source>
        <translation>Écart d’orientation max.</translation>
    </message>
    <message>
        <source>Rotary axes, and X, Y and Z of the machine that hold the tip on its path while they turn, with the share of the limit; above are those of the tip. The lean is that of the tool from its programmed direction.</source>
        <translation>Axes rotatifs, et X, Y et Z de la machine qui tiennent la pointe sur sa trajectoire pendant leur rotation, avec la part de la limite ; ci-dessus ceux de la pointe. L’écart d’orientation est l’angle entre l’outil et sa direction programmée.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Nature</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>Temps enregistré</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
    </message>
    <message>
        <source>Difference [%]</source>
        <translation>Écart [%]</translation>
    </message>
    <message>
        <source>Feeds (rms)</source>
        <translation>Avances (moy. quadr.)</translation>
    </message>
    <message>
        <source>section times</source>
        <translation>temps de sections</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>trace</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>Feed error [%]</source>
        <translation>Erreur d’avance [%]</translation>
    </message>
    <message>
        <source>Time error [%]</source>
        <translation>Erreur de temps [%]</translation>
    </message>
    <message>
        <source>Explains the recordings</source>
        <translation>Explique les enregistrements</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>not fitted</source>
        <translation>non ajusté</translation>
    </message>
    <message>
        <source>identified from %1, %2</source>
        <translation>identifié d’après %1, %2</translation>
    </message>
    <message>
        <source>Begun with</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95&#xa0;%)</translation>
    </message>
    <message>
        <source>Source, or why it was not found</source>
        <translation>Source, ou pourquoi la valeur n’est pas trouvée</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>%1: the %2 of %3 sections that differ most.</source>
        <translation>%1&#xa0;: les %2 sections sur %3 qui diffèrent le plus.</translation>
    </message>
    <message>
        <source>Program, recordings, models or machine have changed since.</source>
        <translation>Programme, enregistrements, modèles ou machine ont changé depuis.</translation>
    </message>
    <message>
        <source>Residual of %1: %2, root mean square of what it leaves over; 1 is noise and sampling alone. A model explains the recordings if it is within 5 % of the feed and 1 % of the time.</source>
        <translation>Résidu de %1&#xa0;: %2, moyenne quadratique de ce qu’il laisse de côté&#xa0;; 1&#xa0;: bruit et échantillonnage seuls. Un modèle explique les enregistrements s’il est à moins de 5&#xa0;% de l’avance et 1&#xa0;% du temps.</translation>
    </message>
    <message>
        <source>What is left over: how far the simulation is behind the recording as it goes on, or what it is longer in each section. A level curve: feed and time agree there.</source>
        <translation>Ce qui reste&#xa0;: de combien la simulation prend du retard sur l’enregistrement à mesure qu’il avance, ou de combien elle est plus longue dans chaque section. Une courbe horizontale&#xa0;: avance et temps y concordent.</translation>
    </message>
    <message>
        <source>The first %1 of %2 recordings.</source>
        <translation>Les %1 premiers enregistrements sur %2.</translation>
    </message>
    <message>
        <source>Residuals of the identification</source>
        <translation>Résidus de l’identification</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>Limits and settings of the machine, found from what it recorded.</source>
        <translation>Limites et réglages de la machine, trouvés d’après ce qu’elle a enregistré.</translation>
    </message>
    <message>
        <source>The search began with the machine %1.</source>
        <translation>La recherche est partie de la machine %1.</translation>
    </message>
    <message>
        <source>Limit or setting</source>
        <translation>Limite ou réglage</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusée</translation>
    </message>
    <message>
        <source>From %1 s to %2 s of %3 s.</source>
        <translation>De %1 s à %2 s sur %3 s.</translation>
    </message>
    <message>
        <source>No motion in this program: there is no time to report.</source>
        <translation>Rien dans ce programme ne prend de temps : il n’y a aucun mouvement à décrire.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Contour errors are those of feed motions; in rapids %1 leaves the programmed path by up to %2.</source>
        <translation>Les erreurs de contour sont celles des déplacements en avance&#xa0;; dans les rapides, %1 s’écarte de la trajectoire programmée jusqu’à %2.</translation>
    </message>
    <message>
        <source>roughly</source>
        <translation>à peu près</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>hors de portée</translation>
    </message>
    <message>
        <source>simulated, not measured</source>
        <translation>simulé, non mesuré</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 lost&lt;/b&gt;, %2 of all; %3.</source>
        <translation>&lt;b&gt;%1 perdues&lt;/b&gt;, %2 du total&#xa0;; %3.</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Endroit %1</translation>
    </message>
    <message>
        <source>Line %1.</source>
        <translation>Ligne %1.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The model %1 uses no contour tolerance.</source>
        <translation>Le modèle %1 n’utilise pas de tolérance de contour.</translation>
    </message>
    <message>
        <source>The model %1 uses no contour tolerance: it has one run for the %2 that were asked for.</source>
        <translation>Le modèle %1 n’utilise pas de tolérance de contour&#xa0;: une seule simulation pour les %2 demandées.</translation>
    </message>
    <message>
        <source>Line of %1</source>
        <translation>Trait de %1</translation>
    </message>
    <message>
        <source>Cycle time over contour error of each run</source>
        <translation>Temps de cycle selon l’erreur de contour de chaque simulation</translation>
    </message>
    <message>
        <source>Cycle time of each run by limiting cause</source>
        <translation>Temps de cycle de chaque simulation par cause limitante</translation>
    </message>
    <message>
        <source>Lens at line %1</source>
        <translation>Loupe à la ligne %1</translation>
    </message>
    <message>
        <source>Largest contour error of %1, line %2, all runs.</source>
        <translation>Plus grande erreur de contour de %1, ligne %2, toutes les simulations.</translation>
    </message>
    <message>
        <source>Largest contour error of the set path, line %1; the actual one, with the drives, is in the table.</source>
        <translation>Plus grande erreur de contour de la trajectoire de consigne, ligne %1&#xa0;; la réelle, avec les entraînements, est dans le tableau.</translation>
    </message>
    <message>
        <source>Largest contour error, line %1.</source>
        <translation>Plus grande erreur de contour, ligne %1.</translation>
    </message>
    <message>
        <source>%1, line %2 and %3 more</source>
        <translation>%1, ligne %2 et %3 de plus</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Endroit</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdu</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>What limits the feed</source>
        <translation>Ce qui limite l’avance</translation>
    </message>
    <message>
        <source>Cycle time over actual contour error</source>
        <translation>Temps de cycle selon l’erreur de contour réelle</translation>
    </message>
    <message>
        <source>Cycle time over contour error</source>
        <translation>Temps de cycle selon l’erreur de contour</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>Against %1</source>
        <translation>Par rapport à %1</translation>
    </message>
    <message>
        <source>Actual contour error</source>
        <translation>Erreur de contour réelle</translation>
    </message>
    <message>
        <source>Executed path of %1, coloured by its feed.</source>
        <translation>Trajectoire exécutée de %1, colorée selon son avance.</translation>
    </message>
    <message>
        <source>Executed path, coloured by its feed.</source>
        <translation>Trajectoire exécutée, colorée selon son avance.</translation>
    </message>
    <message>
        <source>Where %1 still loses time</source>
        <translation>Où %1 perd encore du temps</translation>
    </message>
    <message>
        <source>Where time is lost</source>
        <translation>Où le temps est perdu</translation>
    </message>
    <message>
        <source>programmed</source>
        <translation>programmée</translation>
    </message>
    <message>
        <source>Time lost so far [s]</source>
        <translation>Temps perdu jusque-là [s]</translation>
    </message>
    <message>
        <source>Programmed path of feed motions</source>
        <translation>Trajectoire programmée en avance de travail</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>Time from the slowest instant [s]</source>
        <translation>Temps depuis l’instant le plus lent [s]</translation>
    </message>
    <message>
        <source>Feed and time lost over the path length</source>
        <translation>Avance et temps perdu selon la longueur de trajectoire</translation>
    </message>
    <message>
        <source>Feed of all runs, mean over each of %1 equal parts of the path, and the time lost against the programmed feed. Rapids and pauses are left out.</source>
        <translation>Avance de toutes les simulations, moyenne sur chacune des %1 parts égales de la trajectoire, et temps perdu par rapport à l’avance programmée. Sans rapides ni pauses.</translation>
    </message>
    <message>
        <source>Where %1 loses most</source>
        <translation>Où %1 perd le plus</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Machine, settings, models, trust</source>
        <translation>Machine, réglages, modèles, confiance</translation>
    </message>
    <message>
        <source>Figures of the runs</source>
        <translation>Chiffres des simulations</translation>
    </message>
    <message>
        <source>Values in italics are assumed. Source: %1</source>
        <translation>Les valeurs en italique sont supposées. Source&#xa0;: %1</translation>
    </message>
    <message>
        <source>Settings that differ from the machine&apos;s file</source>
        <translation>Réglages qui diffèrent du fichier de la machine</translation>
    </message>
    <message>
        <source>%1: %2, %3 lines, path of %4 %5, %6 of it rapid.</source>
        <translation>%1&#xa0;: %2, %3 lignes, trajectoire de %4 %5, dont %6 en rapide.</translation>
    </message>
    <message>
        <source>How far to trust it</source>
        <translation>Quelle confiance accorder</translation>
    </message>
    <message>
        <source>All numbers are simulated, not measured: compare one cycle time with the machine before relying on them.</source>
        <translation>Tous les chiffres sont simulés, non mesurés&#xa0;: comparer un temps de cycle avec la machine avant de s’y fier.</translation>
    </message>
    <message>
        <source>Not modelled: cutting forces on the axes, vibration, friction beyond that of the drives that are set, temperature, spindle.</source>
        <translation>Non modélisés&#xa0;: efforts de coupe sur les axes, vibrations, frottements autres que ceux des entraînements donnés, température, broche.</translation>
    </message>
    <message>
        <source>Not modelled: the drives (the axes follow exactly), cutting forces on the axes, vibration, temperature, spindle.</source>
        <translation>Non modélisés&#xa0;: entraînements (les axes suivent exactement), efforts de coupe sur les axes, vibrations, température, broche.</translation>
    </message>
    <message>
        <source>The worst: %1, %2 lost, %3 of %4 %5.</source>
        <translation>Le pire&#xa0;: %1, %2 perdues, %3 au lieu de %4 %5.</translation>
    </message>
    <message>
        <source>Executed path of %1.</source>
        <translation>Trajectoire exécutée de %1.</translation>
    </message>
    <message>
        <source>Executed path.</source>
        <translation>Trajectoire exécutée.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 could not be simulated.&lt;/b&gt; %2</source>
        <translation>&lt;b&gt;%1 n’a pas pu être simulée.&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>Figure %1</translation>
    </message>
    <message>
        <source>thin grey the programmed path</source>
        <translation>en gris fin la trajectoire programmée</translation>
    </message>
    <message>
        <source>dark edges corner blends</source>
        <translation>à bords sombres les raccords d’angle</translation>
    </message>
    <message>
        <source>pink the place and a circle its slowest point</source>
        <translation>en rose l’endroit, un cercle à son point le plus lent</translation>
    </message>
    <message>
        <source>In pictures along the path: %1.</source>
        <translation>Dans les images de la trajectoire&#xa0;: %1.</translation>
    </message>
    <message>
        <source>actual contour error, %1</source>
        <translation>erreur de contour réelle, %1</translation>
    </message>
    <message>
        <source>Feed, mean over each of %1 equal parts of the path, and the time lost against the programmed feed. Rapids and pauses are left out.</source>
        <translation>Avance, moyenne sur chacune des %1 parts égales de la trajectoire, et temps perdu par rapport à l’avance programmée. Sans rapides ni pauses.</translation>
    </message>
    <message>
        <source>The contour error keeps the bound of %1.</source>
        <translation>L’erreur de contour tient la borne de %1.</translation>
    </message>
    <message>
        <source>The contour error is above the bound of %1.</source>
        <translation>L’erreur de contour dépasse la borne de %1.</translation>
    </message>
    <message>
        <source>Another place of %1</source>
        <translation>Un autre lieu de %1</translation>
    </message>
    <message>
        <source>%1, %2 lost, %3 of %4 %5.</source>
        <translation>%1, %2 perdues, %3 au lieu de %4 %5.</translation>
    </message>
    <message>
        <source>Pictures and places are those of %1, which the recordings or the range belong to.</source>
        <translation>Les images et les lieux sont ceux de %1, auxquels appartiennent les enregistrements ou la plage.</translation>
    </message>
    <message>
        <source>The control refuses the program: none of its feed motions is run.</source>
        <translation>La commande refuse le programme&#xa0;: aucun de ses déplacements en avance n’est exécuté.</translation>
    </message>
    <message>
        <source>Mean feed with rapids</source>
        <translation>Avance moyenne, rapides compris</translation>
    </message>
    <message>
        <source>mean feed with rapids, %1</source>
        <translation>avance moy. avec rapides, %1</translation>
    </message>
    <message>
        <source>pins the tool axis</source>
        <translation>en épingles l’axe de l’outil</translation>
    </message>
    <message>
        <source>Motion about the worst places</source>
        <translation>Mouvement autour des pires endroits</translation>
    </message>
    <message>
        <source>Motion of the tool about the places of %1 that lose most; other runs where they are at the same place of the program. Rapids are left out.</source>
        <translation>Mouvement de l’outil autour des endroits de %1 qui perdent le plus&#xa0;; les autres simulations au même endroit du programme. Sans rapides.</translation>
    </message>
    <message>
        <source>Motion of the tool about the places that lose most. Rapids are left out.</source>
        <translation>Mouvement de l’outil autour des endroits qui perdent le plus. Sans rapides.</translation>
    </message>
</context>
<context>
    <name>ResidualPlot</name>
    <message>
        <source>Simulated − recorded [ms]</source>
        <translation>Simulé − enregistré [ms]</translation>
    </message>
    <message>
        <source>Simulated − recorded [s]</source>
        <translation>Simulé − enregistré [s]</translation>
    </message>
    <message>
        <source>Section, by row of the table</source>
        <translation>Section, par ligne du tableau</translation>
    </message>
    <message>
        <source>Recorded time [s]</source>
        <translation>Temps enregistré [s]</translation>
    </message>
</context>
<context>
    <name>RowCopy</name>
    <message>
        <source>&amp;Copy the table</source>
        <translation>&amp;Copier le tableau</translation>
    </message>
    <message>
        <source>Copy all rows to the clipboard for pasting into a spreadsheet</source>
        <translation>Copier toutes les lignes dans le presse-papiers, à coller dans un tableur</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>programmed</source>
        <translation>programmée</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>rapide</translation>
    </message>
    <message>
        <source>executed</source>
        <translation>exécutée</translation>
    </message>
    <message>
        <source>corner blend</source>
        <translation>raccord d’angle</translation>
    </message>
    <message>
        <source>deviation drawn × %1</source>
        <translation>écart dessiné × %1</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Erreur de contour</translation>
    </message>
    <message>
        <source>Limiting cause</source>
        <translation>Cause limitante</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>Limited by: %1</source>
        <translation>Limité par&#xa0;: %1</translation>
    </message>
    <message>
        <source>Time %1 s</source>
        <translation>Temps %1&#xa0;s</translation>
    </message>
    <message>
        <source>Distance to the other run</source>
        <translation>Distance à l’autre simulation</translation>
    </message>
    <message>
        <source>Distance from %1</source>
        <translation>Distance à %1</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>assumed</source>
        <comment>zero point of a work offset</comment>
        <translation>supposé</translation>
    </message>
    <message>
        <source>Feed %1 of %2</source>
        <translation>Avance %1 sur %2</translation>
    </message>
    <message>
        <source>Contour error %1</source>
        <translation>Erreur de contour %1</translation>
    </message>
    <message>
        <source>lost here: %1</source>
        <translation>perdu ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>lost since the start: %1</source>
        <translation>perdu depuis le début&#xa0;: %1</translation>
    </message>
    <message>
        <source>paths %1 apart</source>
        <translation>trajectoires écartées de %1</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distance %1</translation>
    </message>
    <message>
        <source>dX %1   dY %2   dZ %3</source>
        <translation>dX %1   dY %2   dZ %3</translation>
    </message>
    <message>
        <source>Path length %1</source>
        <translation>Longueur de trajectoire %1</translation>
    </message>
    <message>
        <source>Compared with %1:</source>
        <translation>Par rapport à %1&#xa0;:</translation>
    </message>
    <message>
        <source>feed %1, other run %2</source>
        <translation>avance %1, autre simulation %2</translation>
    </message>
    <message>
        <source>reached after %1 s, by the other run after %2 s</source>
        <translation>atteint après %1 s, par l’autre simulation après %2 s</translation>
    </message>
    <message>
        <source>Time lost or gained</source>
        <translation>Temps perdu ou gagné</translation>
    </message>
    <message>
        <source>Time lost or gained against %1</source>
        <translation>Temps perdu ou gagné par rapport à %1</translation>
    </message>
    <message>
        <source>gained</source>
        <translation>gagné</translation>
    </message>
    <message>
        <source>gained here: %1</source>
        <translation>gagné ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>gained since the start: %1</source>
        <translation>gagné depuis le début&#xa0;: %1</translation>
    </message>
    <message>
        <source>actual path</source>
        <translation>trajectoire réelle</translation>
    </message>
    <message>
        <source>Contour error of the actual path %1</source>
        <translation>Erreur de contour de la trajectoire réelle %1</translation>
    </message>
    <message>
        <source>Following error X %1, Y %2, Z %3</source>
        <translation>Écart de poursuite X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Chip thickness %1 (%2 at the programmed feed)</source>
        <translation>Épaisseur de copeau %1 (%2 à l’avance programmée)</translation>
    </message>
    <message>
        <source>Peak cutting force %1 (%2 at the programmed feed)</source>
        <translation>Effort de coupe de crête %1 (%2 à l’avance programmée)</translation>
    </message>
    <message>
        <source>smooth curve</source>
        <translation>courbe lisse</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>axe d’outil</translation>
    </message>
    <message>
        <source>X, Y and Z of the machine</source>
        <translation>X, Y et Z de la machine</translation>
    </message>
    <message>
        <source>start</source>
        <comment>of the path</comment>
        <translation>début</translation>
    </message>
    <message>
        <source>%1 (beneath the path)</source>
        <translation>%1 (sous la trajectoire)</translation>
    </message>
</context>
<context>
    <name>TimeRows</name>
    <message>
        <source>What it consists of</source>
        <translation>Ce qui le compose</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdu</translation>
    </message>
    <message>
        <source>%1 of the cycle time; %2 at the programmed feed</source>
        <translation>%1 du temps de cycle ; %2 à l’avance programmée</translation>
    </message>
    <message>
        <source>Places that lose most</source>
        <translation>Endroits qui perdent le plus</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>%1.
Click to go to the worst place, in line %2.</source>
        <translation>%1.
Cliquer pour aller au pire endroit, ligne %2.</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>What would help (simulated)</source>
        <translation>Quels remèdes (simulés)</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Those of this machine together</source>
        <translation>Ceux de cette machine ensemble</translation>
    </message>
    <message>
        <source>Also simulated</source>
        <translation>Également simulés</translation>
    </message>
    <message>
        <source>None of the changes that were simulated helps</source>
        <translation>Aucun des changements simulés n’aide</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>From line %1; %2 of it rapids. It loses most to: %3.</source>
        <translation>À partir de la ligne %1 ; dont %2 en rapide. Perd le plus à : %3.</translation>
    </message>
    <message>
        <source>%1 instead of %2 (%3 less).</source>
        <translation>%1 au lieu de %2 (%3 de moins).</translation>
    </message>
    <message>
        <source>Max. contour error %1, now %2.</source>
        <translation>Erreur de contour max. %1, actuellement %2.</translation>
    </message>
    <message>
        <source>Whether machine, tool and material bear it is not checked.</source>
        <translation>Si machine, outil et matière le supportent n’est pas vérifié.</translation>
    </message>
    <message>
        <source>Limited by, with braking for it</source>
        <translation>Limité par, freinage compris</translation>
    </message>
</context>
<context>
    <name>TimeTexts</name>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; for %2 programmed: &lt;b&gt;%3&lt;/b&gt; (%4 of the cycle time).</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; pour %2 programmés : &lt;b&gt;%3&lt;/b&gt; (%4 du temps de cycle).</translation>
    </message>
    <message>
        <source>Most is lost here: &lt;b&gt;%1&lt;/b&gt; (%2 s).</source>
        <translation>Perte principale : &lt;b&gt;%1&lt;/b&gt; (%2 s).</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 endroit</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 endroits</translation>
    </message>
    <message>
        <source>Nothing in this program takes time.</source>
        <translation>Rien dans ce programme ne prend de temps.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 to %3, median %4</source>
        <translation>%1 %2 à %3, médiane %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;The control refuses the program:&lt;/b&gt; none of its feed motions is run, and there is no cycle time to explain. Lines that are not run: %1.</source>
        <translation>&lt;b&gt;La commande refuse le programme&#xa0;:&lt;/b&gt; aucun de ses déplacements en avance n’est exécuté, il n’y a pas de temps de cycle à expliquer. Lignes non exécutées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Mean feed with rapids %1, without pauses of %2 s.</source>
        <translation>Avance moyenne %1, rapides compris, sans les pauses de %2&#xa0;s.</translation>
    </message>
    <message>
        <source>Mean feed with rapids %1.</source>
        <translation>Avance moyenne %1, rapides compris.</translation>
    </message>
</context>
<context>
    <name>Tolerance</name>
    <message>
        <source>The tolerance comes from the program.</source>
        <translation>La tolérance vient du programme.</translation>
    </message>
    <message>
        <source>The tolerance comes from the program for some blocks and from the setting for the others.</source>
        <translation>La tolérance vient du programme pour certains blocs et du réglage pour les autres.</translation>
    </message>
    <message>
        <source>The tolerance comes from the setting, not from the program.</source>
        <translation>La tolérance vient du réglage, et non du programme.</translation>
    </message>
</context>
<context>
    <name>ToleranceDialog</name>
    <message>
        <source>Separate the tolerances by spaces or semicolons.</source>
        <translation>Séparez les tolérances par des espaces ou des points-virgules.</translation>
    </message>
    <message>
        <source>Contour tolerances [%1], separated by spaces:</source>
        <translation>Tolérances de contour [%1], séparées par des espaces&#xa0;:</translation>
    </message>
    <message>
        <source>Compare tolerances</source>
        <translation>Comparer des tolérances</translation>
    </message>
</context>
<context>
    <name>TraceMessages</name>
    <message>
        <source> (Trace import options)</source>
        <translation> (options d’import de la trace)</translation>
    </message>
</context>
<context>
    <name>TraceTables</name>
    <message>
        <source>Click to go there</source>
        <translation>Cliquer pour y aller</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Over the part of the program that the trace covers</source>
        <translation>Sur la partie du programme que la trace couvre</translation>
    </message>
    <message>
        <source>What the control recorded</source>
        <translation>Ce que la commande a enregistré</translation>
    </message>
    <message>
        <source>The current run</source>
        <translation>La simulation actuelle</translation>
    </message>
    <message>
        <source>Simulated against recorded</source>
        <translation>Simulé par rapport à enregistré</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Lost [ms]</source>
        <translation>Perdu [ms]</translation>
    </message>
    <message>
        <source>Program line</source>
        <translation>Ligne du programme</translation>
    </message>
    <message>
        <source>Feed of the trace there</source>
        <translation>Avance de la trace à cet endroit</translation>
    </message>
    <message>
        <source>Feed of the current run there, in the same unit</source>
        <translation>Avance de la simulation actuelle à cet endroit, dans la même unité</translation>
    </message>
    <message>
        <source>Time that the control took more than the simulation; below 0: less</source>
        <translation>Temps que la commande a mis en plus de la simulation&#xa0;; sous 0&#xa0;: en moins</translation>
    </message>
    <message>
        <source>Turn [°]</source>
        <translation>Angle [°]</translation>
    </message>
    <message>
        <source>Off [%]</source>
        <translation>Écart [%]</translation>
    </message>
    <message>
        <source>Program line that ends at the corner</source>
        <translation>Ligne du programme qui finit à l’angle</translation>
    </message>
    <message>
        <source>Change of direction</source>
        <translation>Changement de direction</translation>
    </message>
    <message>
        <source>Mean feed of the trace from 0.5 mm before the corner to 0.5 mm behind it, less where blocks are short</source>
        <translation>Avance moyenne de la trace de 0,5 mm avant l’angle à 0,5 mm après, moins là où les blocs sont courts</translation>
    </message>
    <message>
        <source>The same of the current run, in the same unit</source>
        <translation>La même de la simulation actuelle, dans la même unité</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>Time of the part compared</source>
        <translation>Temps de la partie comparée</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Feed (rms)</source>
        <translation>Avance (moy. quadr.)</translation>
    </message>
    <message>
        <source>Root mean square of the difference of the feeds over the path</source>
        <translation>Moyenne quadratique de l’écart des avances le long de la trajectoire</translation>
    </message>
    <message>
        <source>%1 corners (rms)</source>
        <translation>%1 angles (moy. quadr.)</translation>
    </message>
    <message>
        <source>Root mean square of the difference of the mean feeds through corners</source>
        <translation>Moyenne quadratique de l’écart des avances moyennes dans les angles</translation>
    </message>
    <message>
        <source>Largest distance from the path</source>
        <translation>Plus grande distance à la trajectoire</translation>
    </message>
    <message>
        <source>Pass %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>The simulation is %1 % faster than the control</source>
        <translation>La simulation est %1 % plus rapide que la commande</translation>
    </message>
    <message>
        <source>The simulation is %1 % slower than the control</source>
        <translation>La simulation est %1 % plus lente que la commande</translation>
    </message>
    <message>
        <source>%1 (%2 and %3); their feeds differ by %4 (rms over the path).</source>
        <translation>%1 (%2 et %3)&#xa0;; leurs avances diffèrent de %4 (moyenne quadratique le long de la trajectoire).</translation>
    </message>
    <message>
        <source>The trace was moved by X %1 Y %2 Z %3 onto the program.</source>
        <translation>La trace a été déplacée de X %1 Y %2 Z %3 sur le programme.</translation>
    </message>
    <message>
        <source>Read as %1: one sample each %2 ms (%3), noise %4. Its feeds are means over %5 ms, accelerations over %6 ms.</source>
        <translation>Lue comme %1&#xa0;: un échantillon toutes les %2 ms (%3), bruit %4. Ses avances sont des moyennes sur %5 ms, ses accélérations sur %6 ms.</translation>
    </message>
    <message>
        <source>The trace covers %1 % of the path. %2 there (%3 and %4).</source>
        <translation>La trace couvre %1 % de la trajectoire. %2 sur cette partie (%3 et %4).</translation>
    </message>
    <message>
        <source>The simulation is as fast as the control</source>
        <translation>La simulation est aussi rapide que la commande</translation>
    </message>
    <message>
        <source>%1 Without the %2 for which the trace stands still, the times differ by %3 %.</source>
        <translation>%1 Sans les %2 pendant lesquelles la trace reste immobile, les temps diffèrent de %3 %.</translation>
    </message>
</context>
<context>
    <name>VersionTexts</name>
    <message>
        <source>%1–%2</source>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source> (%1 %)</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source> &lt;b&gt;The older program was read with errors.&lt;/b&gt;</source>
        <translation> &lt;b&gt;L’ancien programme a été lu avec des erreurs.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; instead of %2: %3 instead of %4, &lt;b&gt;%5&lt;/b&gt;%6. %7 % of the new path is in the older program too. Max. contour error %8 instead of %9.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; au lieu de %2 : %3 au lieu de %4, &lt;b&gt;%5&lt;/b&gt;%6. %7 % de la nouvelle trajectoire est aussi dans l’ancien programme. Erreur de contour max. %8 au lieu de %9.</translation>
    </message>
</context>
<context>
    <name>WhyText</name>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>On the corner blend, axis %1 runs at its maximum velocity, %2.</source>
        <translation>Sur le raccord d’angle, l’axe %1 est à sa vitesse maximale, %2.</translation>
    </message>
    <message>
        <source>The filters of the control spread every change of feed over %1.</source>
        <translation>Les filtres de la commande étalent chaque changement d’avance sur %1.</translation>
    </message>
    <message>
        <source>Axis %1 is at its maximum jerk, %2, along and across the path combined.</source>
        <translation>L’axe %1 est à son jerk maximal, %2, le long de la trajectoire et en travers réunis.</translation>
    </message>
    <message>
        <source>Axis %1 is at its maximum acceleration, %2, along and across the path combined.</source>
        <translation>L’axe %1 est à son accélération maximale, %2, le long de la trajectoire et en travers réunis.</translation>
    </message>
    <message>
        <source>The tool keeps its speed between two speed changes; with a jerk of %1 along the path they take too long to gain more.</source>
        <translation>L’outil tient sa vitesse entre deux changements de vitesse&#xa0;; avec un jerk de %1 le long de la trajectoire, ils sont trop longs pour gagner plus.</translation>
    </message>
    <message>
        <source>The tool accelerates; the jerk of axis %1 allows %2 along the path.</source>
        <translation>L’outil accélère&#xa0;; le jerk de l’axe %1 permet %2 le long de la trajectoire.</translation>
    </message>
    <message>
        <source>The tool accelerates; axis %1 allows %2 along the path.</source>
        <translation>L’outil accélère&#xa0;; l’axe %1 permet une accélération de %2 le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Rapid traverse: axis %1 runs at its maximum velocity, %2.</source>
        <translation>Déplacement rapide&#xa0;: l’axe %1 est à sa vitesse maximale, %2.</translation>
    </message>
    <message>
        <source>Axis %1 runs at its maximum velocity, %2.</source>
        <translation>L’axe %1 est à sa vitesse maximale, %2.</translation>
    </message>
    <message>
        <source>On the radius of %1 the control allows a curvilinear jerk of %2, of which %3 along the path.</source>
        <translation>Au rayon de %1, la commande permet un jerk curviligne de %2, dont %3 le long de la trajectoire.</translation>
    </message>
    <message>
        <source>The curvature jumps: axis %1 must absorb the change with its jerk of %2 within one interpolation period, %3.</source>
        <translation>La courbure saute&#xa0;: l’axe %1 doit absorber le changement avec son jerk de %2 en une période d’interpolation, %3.</translation>
    </message>
    <message>
        <source>At a higher feed the filters would deviate from the programmed contour by more than the tolerance of %1.</source>
        <translation>Plus vite, les filtres écarteraient l’outil du contour programmé plus que la tolérance de %1 ne le permet.</translation>
    </message>
    <message>
        <source>The tool must stop.</source>
        <translation>L’outil doit s’arrêter.</translation>
    </message>
    <message>
        <source>The program waits.</source>
        <translation>Le programme attend.</translation>
    </message>
    <message>
        <source>The axes wait until the spindle has reached its speed; the time is the machine&apos;s spindle start time.</source>
        <translation>Les axes attendent que la broche ait atteint sa vitesse ; le temps est le temps de démarrage de la broche de la machine.</translation>
    </message>
    <message>
        <source>The tool brakes: in %1 (%2) it must stop, line %3.</source>
        <translation>L’outil freine&#xa0;: dans %1 (%2), il doit s’arrêter, ligne %3.</translation>
    </message>
    <message>
        <source>The tool brakes: in %1 (%2), in line %3, only %4 is possible.</source>
        <translation>L’outil freine&#xa0;: dans %1 (%2), ligne %3, seuls %4 sont possibles.</translation>
    </message>
    <message>
        <source>from the program</source>
        <translation>du programme</translation>
    </message>
    <message>
        <source>Jerk of all axes</source>
        <translation>Jerk de tous les axes</translation>
    </message>
    <message>
        <source>Acceleration of all axes</source>
        <translation>Accélération de tous les axes</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2&#xa0;%</translation>
    </message>
    <message>
        <source>%1 %2 → %3 %4</source>
        <translation>%1 %2 → %3 %4</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>These places are closer together than the filters of the control reach: this one alone uses %1 of the contour tolerance, %2; together they need more.</source>
        <translation>Des endroits plus rapprochés que la portée des filtres de la commande : celui-ci prend à lui seul %1 de la tolérance de contour, %2, mais ensemble ils en demandent davantage.</translation>
    </message>
    <message>
        <source>The tool accelerates and levels off in time for the programmed F %1.</source>
        <translation>L’outil accélère encore, mais se stabilise à temps pour l’avance programmée F %1.</translation>
    </message>
    <message>
        <source>It is slowed by a place further ahead.</source>
        <translation>Elle est ralentie par un endroit plus loin.</translation>
    </message>
    <message>
        <source>The block is %1 long and takes the control at least one interpolation period, %2.</source>
        <translation>Le bloc mesure %1 et demande à la commande au moins une période d’interpolation, %2.</translation>
    </message>
    <message>
        <source>The control looks ahead over the next %1 of the path and must be able to stop within them.</source>
        <translation>La commande anticipe sur les prochains %1 de la trajectoire et doit pouvoir s’y arrêter.</translation>
    </message>
    <message>
        <source>Tool change: it takes the tool change time of the machine.</source>
        <translation>Changement d’outil&#xa0;: il dure le temps de changement d’outil de la machine.</translation>
    </message>
    <message>
        <source>On the corner blend (radius %1), radial acceleration may use %2 of the acceleration limit of axis %3, %4.</source>
        <translation>Sur le raccord d’angle (rayon %1), l’accélération radiale peut utiliser %2 de l’accélération limite de l’axe %3, %4.</translation>
    </message>
    <message>
        <source>On the corner blend, radial jerk may use %1 of the jerk limit of axis %2, %3, and the curvature changes quickly.</source>
        <translation>Sur le raccord d’angle, le jerk radial peut utiliser %1 du jerk limite de l’axe %2, %3, et la courbure change vite.</translation>
    </message>
    <message>
        <source>The corner blend reserves a share of the acceleration limit of axis %1, %2, for radial acceleration: %3; the rest limits the change of speed.</source>
        <translation>Le raccord d’angle réserve une part de l’accélération limite de l’axe %1, %2, à l’accélération radiale&#xa0;: %3&#xa0;; le reste limite le changement de vitesse.</translation>
    </message>
    <message>
        <source>The corner blend reserves a share of the jerk limit of axis %1, %2, for radial jerk: %3; the rest limits how fast the acceleration changes.</source>
        <translation>Le raccord d’angle réserve une part du jerk limite de l’axe %1, %2, au jerk radial&#xa0;: %3&#xa0;; le reste limite la variation de l’accélération.</translation>
    </message>
    <message>
        <source>The tool runs at the programmed feed: F %1.</source>
        <translation>L’outil va à l’avance programmée&#xa0;: F %1.</translation>
    </message>
    <message>
        <source>On the radius of %1, radial acceleration uses the full acceleration of axis %2, %3.</source>
        <translation>Au rayon de %1, l’accélération radiale utilise toute l’accélération de l’axe %2, %3.</translation>
    </message>
    <message>
        <source>On the radius of %1, radial jerk uses the full jerk of axis %2, %3.</source>
        <translation>Au rayon de %1, le jerk radial utilise tout le jerk de l’axe %2, %3.</translation>
    </message>
    <message>
        <source>Contour error %1, of which the set path has %2: the drives make most of it. The axes are %3 behind across the path; a higher Kv, more feed-forward or a lower feed reduces that.</source>
        <translation>Erreur de contour %1, dont %2 pour la trajectoire de consigne : les entraînements en font l’essentiel. Les axes sont en retard de %3 perpendiculairement à la trajectoire ; un Kv plus élevé, plus d’anticipation ou une avance plus faible réduit cet écart.</translation>
    </message>
    <message>
        <source>The smooth curve through the blocks bends here, and its bend changes: turning takes %1 of the jerk of axis %2, %3; the rest is for changes of speed.</source>
        <translation>La courbe lisse qui passe par les blocs tourne ici, et sa courbure change : tourner prend %1 du jerk de l’axe %2, %3 ; le reste sert aux changements de vitesse.</translation>
    </message>
    <message>
        <source>The smooth curve through the blocks bends here: turning takes %1 of the acceleration of axis %2, %3; the rest is for changes of speed.</source>
        <translation>La courbe lisse qui passe par les blocs tourne ici : tourner prend %1 de l’accélération de l’axe %2, %3 ; le reste sert aux changements de vitesse.</translation>
    </message>
    <message>
        <source>In the corner the control allows the speed at which an arc no farther from it than %1 would use the full acceleration of axis %2, %3.</source>
        <translation>Dans l’angle, la commande permet la vitesse à laquelle un arc qui ne s’en écarte pas de plus de %1 utiliserait toute l’accélération de l’axe %2, %3.</translation>
    </message>
    <message>
        <source>The control allows %1 in a corner of 90°, and here as much more or less as the corner is wider or sharper.</source>
        <translation>La commande permet %1 dans un angle de 90°, et ici d’autant plus ou moins que l’angle est plus ouvert ou plus vif.</translation>
    </message>
    <message>
        <source>The control keeps a part of the way between two slow places for constant speed, so that the tool does not accelerate any further.</source>
        <translation>La commande réserve une part du trajet entre deux endroits lents à la vitesse constante : l’outil n’accélère pas davantage.</translation>
    </message>
    <message>
        <source>Where the blocks meet the velocity jumps: the axes must absorb that within one period.</source>
        <translation>À la jonction des blocs, la vitesse saute : les axes doivent l’absorber en une période.</translation>
    </message>
    <message>
        <source>The tool runs at the largest speed that the control allows along the path.</source>
        <translation>L’outil avance à la plus grande vitesse que la commande permet le long de la trajectoire.</translation>
    </message>
    <message>
        <source>The tool accelerates as much as the control allows along the path.</source>
        <translation>L’outil accélère autant que la commande le permet le long de la trajectoire.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The tool accelerates with %1, what turning and blends leave of the acceleration of the axes.</source>
        <translation>L’outil accélère à %1, ce que virages et raccords laissent de l’accélération des axes.</translation>
    </message>
    <message>
        <source>In the corner the control goes over from one block to the next within the blend tolerance, with what that leaves of the acceleration.</source>
        <translation>Dans l’angle, la commande passe d’un bloc au suivant dans la tolérance de raccord, avec ce qui reste pour cela de l’accélération.</translation>
    </message>
    <message>
        <source>Turning on the arc takes the part of the acceleration that the control keeps for it.</source>
        <translation>Le virage sur l’arc prend la part de l’accélération que la commande lui réserve.</translation>
    </message>
    <message>
        <source>The control rounds the corner with an arc of radius %1 within the blend tolerance; turning on it takes %2 of the acceleration of axis %3.</source>
        <translation>La commande arrondit l’angle par un arc de rayon %1 dans la tolérance de raccord ; y tourner prend %2 de l’accélération de l’axe %3.</translation>
    </message>
    <message>
        <source>On the radius of %1 turning takes %2 of the acceleration of axis %3; the control keeps the rest for changes of speed.</source>
        <translation>Sur le rayon de %1, le virage prend %2 de l’accélération de l’axe %3 ; la commande garde le reste pour changer de vitesse.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block as fast as its velocity limit allows.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc aussi vite que le permet sa limite de vitesse.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns while the tool stands: it takes what the limits of this axis allow, or the programmed feed if that is lower.</source>
        <translation>L’axe rotatif %1 tourne pendant que l’outil s’arrête : cela prend ce que permettent les limites de cet axe, ou l’avance programmée si elle est plus basse.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block at its maximum velocity, %2: it turns by %3 of path.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc à sa vitesse maximale, %2 : il tourne de %3 de trajectoire.</translation>
    </message>
    <message>
        <source>Rotary axes turn along this block; axis %1, which makes up for that, runs at its maximum velocity, %2: it moves %3 times as far as the tip.</source>
        <translation>Des axes rotatifs tournent le long de ce bloc ; l’axe %1, qui le compense, se déplace à sa vitesse maximale, %2 : il parcourt %3 fois le chemin de la pointe.</translation>
    </message>
    <message>
        <source>The tool is %1 from the first rotary axis, near the singular position, where that axis turns by 1/sin of this angle.</source>
        <translation>L’outil est à %1 du premier axe rotatif, près de la position singulière, où cet axe tourne de 1/sin de cet angle.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block or beside it: its acceleration limit holds the change of speed.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc ou à côté : sa limite d’accélération retient la variation de vitesse.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block or beside it: its jerk limit holds the change of speed.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc ou à côté : sa limite de jerk retient la variation de vitesse.</translation>
    </message>
    <message>
        <source>The tool turns about its tip, which X, Y and Z hold: it takes what the limits of axis %1 allow, or the programmed feed in degrees a minute if that is lower.</source>
        <translation>L’outil pivote autour de sa pointe, que X, Y et Z maintiennent : il prend ce que permettent les limites de l’axe %1, ou l’avance programmée en degrés par minute si elle est plus faible.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block or beside it; turning takes %2 of its maximum acceleration, %3, and changes of the speed have the rest.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc ou à côté ; cela prend %2 de son accélération maximale, %3, et le reste sert aux changements de vitesse.</translation>
    </message>
    <message>
        <source>Rotary axes turn along this block or beside it; that takes %2 of the maximum acceleration of axis %1, %3, and changes of the speed have the rest.</source>
        <translation>Des axes rotatifs tournent le long de ce bloc ou à côté ; cela prend %2 de l’accélération maximale de l’axe %1, %3, et le reste sert aux changements de vitesse.</translation>
    </message>
    <message>
        <source>Rotary axis %1 turns along this block or beside it; turning takes %2 of its maximum jerk, %3, and changes of the acceleration have the rest.</source>
        <translation>L’axe rotatif %1 tourne le long de ce bloc ou à côté ; cela prend %2 de son jerk maximal, %3, et le reste sert aux changements d’accélération.</translation>
    </message>
    <message>
        <source>Rotary axes turn along this block or beside it; that takes %2 of the maximum jerk of axis %1, %3, and changes of the acceleration have the rest.</source>
        <translation>Des axes rotatifs tournent le long de ce bloc ou à côté ; cela prend %2 du jerk maximal de l’axe %1, %3, et le reste sert aux changements d’accélération.</translation>
    </message>
    <message>
        <source>Rotary axis %1 does not turn evenly along this block or beside it, so that every change of the speed takes jerk: %2 of its maximum, %3, is for that.</source>
        <translation>L’axe rotatif %1 ne tourne pas régulièrement le long de ce bloc ou à côté, si bien que tout changement de vitesse demande du jerk : %2 de son maximum, %3, y est consacré.</translation>
    </message>
    <message>
        <source>Rotary axes turn along this block or beside it and axis %1 makes up for that, so that every change of the speed takes jerk: %2 of its maximum, %3, is for that.</source>
        <translation>Des axes rotatifs tournent le long de ce bloc ou à côté et l’axe %1 compense, si bien que tout changement de vitesse demande du jerk : %2 de son maximum, %3, y est consacré.</translation>
    </message>
    <message>
        <source>The tool must stop: the program begins or ends here.</source>
        <translation>L’outil doit s’arrêter&#xa0;: le programme commence ou finit ici.</translation>
    </message>
    <message>
        <source>The tool must stop: a rapid begins or ends here.</source>
        <translation>L’outil doit s’arrêter&#xa0;: un rapide commence ou finit ici.</translation>
    </message>
    <message>
        <source>The tool must stop: an exact stop or a contour tolerance of 0 is in force.</source>
        <translation>L’outil doit s’arrêter&#xa0;: un arrêt exact ou une tolérance de contour de 0 est en vigueur.</translation>
    </message>
    <message>
        <source>The block is %1 long and takes the control at least %2 to prepare: longer blocks, with fewer points, are faster.</source>
        <translation>Le bloc fait %1 et la commande met au moins %2 à le préparer : des blocs plus longs, avec moins de points, sont plus rapides.</translation>
    </message>
    <message>
        <source>less than 1 %</source>
        <translation>moins de 1&#xa0;%</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>unknown unit &apos;{}&apos;; write the number in one of: {}</source>
        <translation>unité &apos;{}&apos; inconnue&#xa0;; écrivez le nombre dans l’une de ces unités&#xa0;: {}</translation>
    </message>
    <message>
        <source>rev/min</source>
        <translation>tr/min</translation>
    </message>
    <message>
        <source>rev/s²</source>
        <translation>tr/s²</translation>
    </message>
    <message>
        <source>rev/s³</source>
        <translation>tr/s³</translation>
    </message>
    <message>
        <source>chip below its least thickness (rubbing)</source>
        <translation>copeau plus mince que le minimum (frottement)</translation>
    </message>
    <message>
        <source>chip above its largest thickness</source>
        <translation>copeau plus épais que le maximum</translation>
    </message>
    <message>
        <source>peak force above its bound</source>
        <translation>effort maximal au-delà de la borne</translation>
    </message>
    <message>
        <source>torque above its bound</source>
        <translation>couple au-delà de la borne</translation>
    </message>
    <message>
        <source>power above its bound</source>
        <translation>puissance au-delà de la borne</translation>
    </message>
    <message>
        <source>engagement as given, not simulated along the path; circular tooth path, no runout, no deflection; coefficients of the material as given</source>
        <translation>engagement tel que donné, non simulé le long de la trajectoire&#xa0;; trajectoire de dent circulaire, sans faux-rond ni flexion&#xa0;; coefficients du matériau tels que donnés</translation>
    </message>
    <message>
        <source>axis velocity</source>
        <translation>vitesse d’un axe</translation>
    </message>
    <message>
        <source>axis acceleration</source>
        <translation>accélération d’un axe</translation>
    </message>
    <message>
        <source>axis jerk</source>
        <translation>jerk d’un axe</translation>
    </message>
    <message>
        <source>programmed feed</source>
        <translation>avance programmée</translation>
    </message>
    <message>
        <source>rapid traverse</source>
        <translation>déplacement rapide</translation>
    </message>
    <message>
        <source>velocity of axis %1</source>
        <translation>vitesse de l’axe %1</translation>
    </message>
    <message>
        <source>acceleration of axis %1</source>
        <translation>accélération de l’axe %1</translation>
    </message>
    <message>
        <source>jerk of axis %1</source>
        <translation>jerk de l’axe %1</translation>
    </message>
    <message>
        <source>radial acceleration</source>
        <translation>accélération radiale</translation>
    </message>
    <message>
        <source>radial acceleration of axis %1</source>
        <translation>accélération radiale de l’axe %1</translation>
    </message>
    <message>
        <source>radial jerk</source>
        <translation>jerk radial</translation>
    </message>
    <message>
        <source>radial jerk of axis %1</source>
        <translation>jerk radial de l’axe %1</translation>
    </message>
    <message>
        <source>velocity on a blend</source>
        <translation>vitesse sur un raccord</translation>
    </message>
    <message>
        <source>velocity of axis %1 on a blend</source>
        <translation>vitesse de l’axe %1 sur un raccord</translation>
    </message>
    <message>
        <source>radial acceleration on a blend</source>
        <translation>accélération radiale sur un raccord</translation>
    </message>
    <message>
        <source>radial acceleration of axis %1 on a blend</source>
        <translation>accélération radiale de l’axe %1 sur un raccord</translation>
    </message>
    <message>
        <source>radial jerk on a blend</source>
        <translation>jerk radial sur un raccord</translation>
    </message>
    <message>
        <source>radial jerk of axis %1 on a blend</source>
        <translation>jerk radial de l’axe %1 sur un raccord</translation>
    </message>
    <message>
        <source>tangential acceleration on a blend</source>
        <translation>accélération tangentielle sur un raccord</translation>
    </message>
    <message>
        <source>tangential acceleration of axis %1 on a blend</source>
        <translation>accélération tangentielle de l’axe %1 sur un raccord</translation>
    </message>
    <message>
        <source>tangential jerk on a blend</source>
        <translation>jerk tangentiel sur un raccord</translation>
    </message>
    <message>
        <source>tangential jerk of axis %1 on a blend</source>
        <translation>jerk tangentiel de l’axe %1 sur un raccord</translation>
    </message>
    <message>
        <source>curvilinear jerk</source>
        <translation>jerk curviligne</translation>
    </message>
    <message>
        <source>jerk at a change of curvature</source>
        <translation>jerk à un changement de courbure</translation>
    </message>
    <message>
        <source>jerk of axis %1 at a change of curvature</source>
        <translation>jerk de l’axe %1 à un changement de courbure</translation>
    </message>
    <message>
        <source>interpolation period</source>
        <translation>période d’interpolation</translation>
    </message>
    <message>
        <source>contour tolerance</source>
        <translation>tolérance de contour</translation>
    </message>
    <message>
        <source>look-ahead horizon</source>
        <translation>horizon d’anticipation</translation>
    </message>
    <message>
        <source>braking for a slower place ahead</source>
        <translation>ralentissement pour la suite</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>arrêt précis</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>temporisation</translation>
    </message>
    <message>
        <source>tool change</source>
        <translation>changement d’outil</translation>
    </message>
    <message>
        <source>spindle start</source>
        <translation>démarrage de la broche</translation>
    </message>
    <message>
        <source>Tool change time</source>
        <translation>Temps de changement d’outil</translation>
    </message>
    <message>
        <source>Time of a tool change, from the end of the last motion to the start of the next one; without it tool changes are not included in the cycle time.</source>
        <translation>Temps d’un changement d’outil, de la fin du dernier mouvement au début du suivant ; sans lui, les changements d’outil ne sont pas comptés dans le temps de cycle.</translation>
    </message>
    <message>
        <source>Spindle start time</source>
        <translation>Temps de démarrage de la broche</translation>
    </message>
    <message>
        <source>Time until the spindle has reached its speed, during which the axes wait; without it spindle starts are not included in the cycle time.</source>
        <translation>Temps jusqu’à ce que la broche ait atteint sa vitesse, pendant lequel les axes attendent ; sans lui, les démarrages de broche ne sont pas comptés dans le temps de cycle.</translation>
    </message>
    <message>
        <source>Machine coordinate of the reference point that G28 and G74 move to; without it such a move is neither drawn nor timed.</source>
        <translation>Coordonnée machine du point de référence que rejoignent G28 et G74 ; sans elle, un tel déplacement n’est ni dessiné ni chronométré.</translation>
    </message>
    <message>
        <source>Machine coordinate of the position that G30 and G75 move to; without it such a move is neither drawn nor timed.</source>
        <translation>Coordonnée machine de la position que rejoignent G30 et G75 ; sans elle, un tel déplacement n’est ni dessiné ni chronométré.</translation>
    </message>
    <message>
        <source>Machine coordinate of the zero point of the coordinates shown, 0 where work offsets are given in machine coordinates; without it moves to machine positions are neither drawn nor timed.</source>
        <translation>Coordonnée machine de l’origine des coordonnées affichées, 0 si les décalages d’origine sont donnés en coordonnées machine ; sans elle, les déplacements vers des positions machine ne sont ni dessinés ni chronométrés.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Maximum velocity of this axis; rapids run at the speed at which the first axis reaches it.</source>
        <translation>Vitesse maximale de cet axe&#xa0;; les rapides se font à la vitesse à laquelle le premier axe l’atteint.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Maximum acceleration of this axis, along and across the path combined.</source>
        <translation>Accélération maximale de cet axe, le long de la trajectoire et en travers réunis.</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Jerk on blends</source>
        <translation>Jerk sur les raccords</translation>
    </message>
    <message>
        <source>Contour tolerance</source>
        <translation>Tolérance de contour</translation>
    </message>
    <message>
        <source>Maximum distance of the path from the programmed corners; with larger values the control slows down less there. 0: it stops in every corner.</source>
        <translation>Écart permis à la commande par rapport aux angles programmés&#xa0;; plus il est grand, moins elle y ralentit. 0&#xa0;: elle s’arrête à chaque angle.</translation>
    </message>
    <message>
        <source>Merge collinear blocks</source>
        <translation>Réunir les blocs alignés</translation>
    </message>
    <message>
        <source>Successive lines of one feed and one direction are planned as one block if every point between them lies within this distance of it, so that corner blends are not limited by half of a part of a line. Without it, or 0, every line is a block.</source>
        <translation>Des droites successives de même avance et de même direction sont planifiées comme un seul bloc si chaque point entre elles en est à cette distance au plus, de sorte que les raccords ne sont pas limités à la moitié d’un morceau de droite. Sans valeur, ou 0, chaque droite est un bloc.</translation>
    </message>
    <message>
        <source>Tolerance of the program</source>
        <translation>Tolérance du programme</translation>
    </message>
    <message>
        <source>Interpolation period</source>
        <translation>Période d’interpolation</translation>
    </message>
    <message>
        <source>Radial share of acceleration</source>
        <translation>Part radiale de l’accélération</translation>
    </message>
    <message>
        <source>Radial share of jerk</source>
        <translation>Part radiale du jerk</translation>
    </message>
    <message>
        <source>Curvilinear jerk</source>
        <translation>Jerk curviligne</translation>
    </message>
    <message>
        <source>Tangential share of curvilinear jerk</source>
        <translation>Part tangentielle du jerk curviligne</translation>
    </message>
    <message>
        <source>CAM baseline</source>
        <translation>Référence FAO</translation>
    </message>
    <message>
        <source>Local smoothing by cubic blends (Sinumerik 840D)</source>
        <translation>Lissage local par raccords cubiques (Sinumerik 840D)</translation>
    </message>
    <message>
        <source>Tangent weight alpha</source>
        <translation>Poids alpha des tangentes</translation>
    </message>
    <message>
        <source>Weight of the end tangents of a blend; 2.5 was identified on a Sinumerik 840D.</source>
        <translation>Poids des tangentes aux extrémités d’un raccord&#xa0;; 2,5 a été identifié sur une Sinumerik 840D.</translation>
    </message>
    <message>
        <source>Share of the contour tolerance that the control uses; 0 for the identified rule: 0.6 where an axis reverses in the corner, else 0.8.</source>
        <translation>Part de la tolérance de contour que la commande utilise&#xa0;; 0 pour la règle identifiée&#xa0;: 0,6 là où un axe s’inverse dans l’angle, sinon 0,8.</translation>
    </message>
    <message>
        <source>Interpretation of the paper</source>
        <translation>Lecture de l’article</translation>
    </message>
    <message>
        <source>corrected: the acceleration continues after a blend; published: it drops to zero there, as in the figures of the paper; strict: constant du/dt on a blend, ramps where blends meet, every limit kept.</source>
        <translation>corrigée&#xa0;: l’accélération se poursuit après un raccord&#xa0;; publiée&#xa0;: elle est abandonnée à sa fin, comme dans les figures de l’article&#xa0;; stricte&#xa0;: du/dt constant sur un raccord, en rampe là où des raccords se touchent, toutes les limites respectées.</translation>
    </message>
    <message>
        <source>Circular interpolation (Sinumerik 840D)</source>
        <translation>Interpolation circulaire (Sinumerik 840D)</translation>
    </message>
    <message>
        <source>One feed for each arc, from the curvilinear jerk of the control and from what the axes allow where it is reached; speed is lost at every change of curvature; jerk-limited ramps in between. Corners are exact stops: the paper states that the control rounds them, but not how.</source>
        <translation>Une seule avance par arc, d’après le jerk curviligne de la commande et ce que les axes permettent là où il est atteint&#xa0;; perte de vitesse à chaque changement de courbure&#xa0;; rampes à jerk limité entre les deux. Les angles sont des arrêts précis&#xa0;: l’article dit que la commande les arrondit, mais pas comment.</translation>
    </message>
    <message>
        <source>Connecting arcs, static and dynamic look-ahead (Sinumerik 840D, TNC 430)</source>
        <translation>Arcs de raccord, anticipation statique et dynamique (Sinumerik 840D, TNC 430)</translation>
    </message>
    <message>
        <source>Compaction length</source>
        <translation>Longueur de compactage</translation>
    </message>
    <message>
        <source>Velocity pulses through FIR filters (Heidenhain TNC 640)</source>
        <translation>Impulsions de vitesse et filtres RIF (Heidenhain TNC 640)</translation>
    </message>
    <message>
        <source>Number of filters</source>
        <translation>Nombre de filtres</translation>
    </message>
    <message>
        <source>Jerk of the filters</source>
        <translation>Jerk des filtres</translation>
    </message>
    <message>
        <source>Filter time</source>
        <translation>Temps de filtrage</translation>
    </message>
    <message>
        <source>Keep the tolerance where corners are close</source>
        <translation>Tenir la tolérance aux angles proches</translation>
    </message>
    <message>
        <source>Time-optimal bound</source>
        <translation>Borne en temps optimal</translation>
    </message>
    <message>
        <source>The shortest time in which any control could run the path of another model, including its blends, within the axis limits and the programmed feed: what a better control could still gain. The settings of the other model shape the path.</source>
        <translation>Le temps minimal que pourrait mettre une loi de vitesse sur la trajectoire parcourue par un autre modèle, raccords compris, sous les limites des axes et l’avance programmée&#xa0;: ce qu’une meilleure commande pourrait encore gagner. Les réglages de l’autre modèle déterminent la trajectoire.</translation>
    </message>
    <message>
        <source>Path of the model</source>
        <translation>Trajectoire du modèle</translation>
    </message>
    <message>
        <source>Model whose path is run, including corner blends; for ward the path that its filters produce.</source>
        <translation>Modèle dont la trajectoire est parcourue, raccords d’angle compris ; pour ward, celle que tracent ses filtres.</translation>
    </message>
    <message>
        <source>Jerk limits</source>
        <translation>Limites de jerk</translation>
    </message>
    <message>
        <source>off: the fastest within velocity and acceleration limits, which no control can beat; on: also within the jerk of every axis, close to the fastest and slow to compute.</source>
        <translation>non&#xa0;: la loi la plus rapide sous les limites de vitesse et d’accélération, qu’aucune autre ne peut battre&#xa0;; oui&#xa0;: une loi qui respecte aussi le jerk de chaque axe, proche de la plus rapide, et longue à calculer.</translation>
    </message>
    <message>
        <source>Tolerances and blend distances of the program are not used: the model has no blends.</source>
        <translation>Les tolérances et distances de raccord du programme ne sont pas suivies : le modèle n’a pas de raccords.</translation>
    </message>
    <message>
        <source>Compaction requested by the program is not simulated: short blocks are not joined.</source>
        <translation>La compression demandée par le programme n’est pas suivie : les blocs courts ne sont pas réunis.</translation>
    </message>
    <message>
        <source>BRISK of the program is not simulated: the jerk along the path stays limited.</source>
        <translation>BRISK du programme n’est pas suivi : le jerk le long de la trajectoire reste limité.</translation>
    </message>
    <message>
        <source>DRIVE of the program is simulated as SOFT: the speed above which it reduces the acceleration is in the machine data of the control.</source>
        <translation>DRIVE du programme est exécuté comme SOFT : la vitesse au-dessus de laquelle il réduit l’accélération se trouve dans les données machine de la commande.</translation>
    </message>
    <message>
        <source>Feed-forward switched off by the program is not simulated: the axes are assumed to follow without lag.</source>
        <translation>La commande anticipatrice (feed-forward) que le programme désactive n’est pas suivie : les axes sont supposés suivre sans retard.</translation>
    </message>
    <message>
        <source>Look-ahead switched off by the program is not simulated.</source>
        <translation>L’anticipation de blocs (look-ahead) que le programme désactive n’est pas suivie.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>off</source>
        <translation>non</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>corrigée</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publiée</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>stricte</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>Look-ahead (blocks)</source>
        <translation>Anticipation (blocs)</translation>
    </message>
    <message>
        <source>Look-ahead law</source>
        <translation>Loi d’anticipation</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur de trajectoire</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Avance programmée</translation>
    </message>
    <message>
        <source>Tangential acceleration</source>
        <translation>Accélération tangentielle</translation>
    </message>
    <message>
        <source>Tangential jerk</source>
        <translation>Jerk tangentiel</translation>
    </message>
    <message>
        <source>Acceleration across the path</source>
        <translation>Accélération normale à la trajectoire</translation>
    </message>
    <message>
        <source>Feed / programmed</source>
        <translation>Avance / programmée</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position de %1</translation>
    </message>
    <message>
        <source>Velocity of %1</source>
        <translation>Vitesse de %1</translation>
    </message>
    <message>
        <source>Acceleration of %1</source>
        <translation>Accélération de %1</translation>
    </message>
    <message>
        <source>Jerk of %1</source>
        <translation>Jerk de %1</translation>
    </message>
    <message>
        <source>achieved</source>
        <translation>réalisée</translation>
    </message>
    <message>
        <source>programmed</source>
        <translation>programmée</translation>
    </message>
    <message>
        <source>tangential</source>
        <translation>tangentielle</translation>
    </message>
    <message>
        <source>across</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>velocity filters</source>
        <translation>filtres de vitesse</translation>
    </message>
    <message>
        <source>Curves of the program are simulated as tangent arcs: where the curvature jumps, a control that limits the jerk slows down, and the time shown is up to 2.4 times that on the curve itself.</source>
        <translation>Les courbes du programme sont simulées comme des arcs tangents&#xa0;: là où la courbure saute, une commande qui limite le jerk ralentit, et le temps indiqué atteint 2,4 fois celui de la courbe elle-même.</translation>
    </message>
    <message>
        <source>Maximum rate of change of acceleration on programmed lines and arcs; small values are gentle on the machine and cost most time on short blocks.</source>
        <translation>Taux maximal de variation de l’accélération sur les droites et arcs programmés&#xa0;; de petites valeurs ménagent la machine et coûtent surtout du temps sur les blocs courts.</translation>
    </message>
    <message>
        <source>Maximum rate of change of acceleration on the corner blends that the control inserts.</source>
        <translation>Taux maximal de variation de l’accélération sur les raccords d’angle insérés par la commande.</translation>
    </message>
    <message>
        <source>Time between two set points of the control; a block shorter than the distance that the feed covers in one period is run more slowly.</source>
        <translation>Temps entre deux consignes de la commande&#xa0;; un bloc plus court que la distance parcourue en une période à l’avance programmée est exécuté plus lentement.</translation>
    </message>
    <message>
        <source>Number of blocks the control plans ahead; it must be able to stop within them, so a small number keeps the feed low on short blocks.</source>
        <translation>Nombre de blocs que la commande planifie à l’avance&#xa0;; elle doit pouvoir s’arrêter dans ces blocs&#xa0;: un petit nombre maintient donc l’avance basse sur des blocs courts.</translation>
    </message>
    <message>
        <source>Share of the acceleration of every axis that is available for radial acceleration on a corner blend; the rest is left for accelerating and braking along the path.</source>
        <translation>Part de l’accélération de chaque axe disponible pour l’accélération radiale sur un raccord d’angle&#xa0;; le reste sert à accélérer et à freiner le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Share of the jerk of every axis that is available for radial jerk on a corner blend; the rest is left for accelerating and braking along the path.</source>
        <translation>Part du jerk de chaque axe disponible pour le jerk radial sur un raccord d’angle&#xa0;; le reste sert à accélérer et à freiner le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Maximum jerk along the path; it limits the feed on arcs to the cube root of jerk times radius squared.</source>
        <translation>Jerk maximal le long de la trajectoire&#xa0;; il limite l’avance sur les arcs à la racine cubique du jerk multiplié par le carré du rayon.</translation>
    </message>
    <message>
        <source>Share of the curvilinear jerk used in the tangential direction; the rest is used in the normal direction.</source>
        <translation>Part du jerk curviligne utilisée dans la direction tangentielle&#xa0;; le reste l’est dans la direction normale.</translation>
    </message>
    <message>
        <source>Path length divided by programmed feed, block by block; rapids at axis speed; dwells as programmed: the time that a CAM system predicts.</source>
        <translation>Longueur de trajectoire divisée par l’avance programmée, bloc par bloc&#xa0;; rapides à la vitesse des axes&#xa0;; temporisations telles que programmées&#xa0;: le temps qu’annonce un logiciel de FAO.</translation>
    </message>
    <message>
        <source>Corners between lines are blended by cubic Hermite curves within the contour tolerance; jerk-limited ramps on the lines, per-axis limits with radial shares on the blends, look-ahead over a number of blocks. Arcs and tangent junctions, which the paper does not cover, keep the static limits of Tapie 2007.</source>
        <translation>Les angles entre droites sont raccordés par des courbes cubiques d’Hermite dans la tolérance de contour&#xa0;; rampes à jerk limité sur les droites, limites par axe avec parts radiales sur les raccords, anticipation sur un certain nombre de blocs. Les arcs et les jonctions tangentes, que l’article ne traite pas, gardent les limites statiques de Tapie 2007.</translation>
    </message>
    <message>
        <source>Corners between lines are blended by circular arcs within the contour tolerance and passed at constant speed; where blends meet, they are passed within ramps. Limits apply along tangent and normal instead of per axis; jerk-limited ramps on the lines, look-ahead. Arcs and tangent junctions keep the static limits of Tapie 2007.</source>
        <translation>Les angles entre droites sont raccordés par des arcs de cercle dans la tolérance de contour et passés à vitesse constante&#xa0;; là où des raccords se touchent, ils sont passés dans des rampes. Limites prises selon la tangente et la normale au lieu de chaque axe&#xa0;; rampes à jerk limité sur les droites, anticipation. Les arcs et les jonctions tangentes gardent les limites statiques de Tapie 2007.</translation>
    </message>
    <message>
        <source>dynamic: ramps planned over the blocks ahead; static: every block at its own feed, as if feed changes took no time.</source>
        <translation>dynamique&#xa0;: rampes planifiées sur les blocs à venir&#xa0;; statique&#xa0;: chaque bloc à sa propre avance, comme si les changements d’avance ne prenaient pas de temps.</translation>
    </message>
    <message>
        <source>Connecting arcs are inserted at corners between lines within the contour tolerance (TIT); short blocks are merged. Static look-ahead assigns one feed to every block and arc; dynamic look-ahead plans ramps below it. Helices, dwells, rapids and corners at an arc, which the paper does not cover, keep the static limits of arcs and lines or are exact stops.</source>
        <translation>Des arcs de raccord sont insérés aux angles entre droites dans la tolérance de contour (TIT)&#xa0;; les blocs courts sont réunis. L’anticipation statique attribue une avance à chaque bloc et à chaque arc&#xa0;; l’anticipation dynamique planifie des rampes au-dessous. Hélices, temporisations, rapides et angles touchant un arc, que l’article ne traite pas, gardent les limites statiques des arcs et des droites ou sont des arrêts précis.</translation>
    </message>
    <message>
        <source>Number of moving averages in series; 3 are closer to the control in the paper, 2 are simpler.</source>
        <translation>Nombre de moyennes glissantes en série&#xa0;; 3 s’approchent mieux de la commande de l’article, 2 sont plus simples.</translation>
    </message>
    <message>
        <source>Used only if the filter time is 0: jerk of a ramp to the highest programmed feed between two stops; the filter time is the square root of this feed over the jerk. 0: the smallest axis jerk.</source>
        <translation>Utilisé seulement si le temps de filtrage est 0&#xa0;: jerk d’une rampe jusqu’à la plus grande avance programmée entre deux arrêts&#xa0;; le temps de filtrage est la racine carrée de cette avance divisée par le jerk. 0&#xa0;: le plus petit jerk des axes.</translation>
    </message>
    <message>
        <source>Length of one moving average, the same for all feeds. 0: computed from the highest programmed feed between two stops and the jerk of the filters; a higher programmed feed can then slow the program down.</source>
        <translation>Durée d’une moyenne glissante, la même pour toutes les avances. 0&#xa0;: calculée d’après la plus grande avance programmée entre deux arrêts et le jerk des filtres&#xa0;; une avance programmée plus élevée peut alors ralentir le programme.</translation>
    </message>
    <message>
        <source>on: corners are slowed down until the actual contour error is within the tolerance; off: every corner is treated as if it were alone, as in the paper.</source>
        <translation>oui&#xa0;: les angles sont ralentis jusqu’à ce que l’erreur de contour réelle soit dans la tolérance&#xa0;; non&#xa0;: chaque angle est traité comme s’il était seul, comme dans l’article.</translation>
    </message>
    <message>
        <source>Every block is a velocity pulse, reduced around corners until the contour tolerance is kept; two or three equal moving averages smooth the pulses of each axis. On arcs, which the paper does not cover, the pulses follow the tangent; they keep the static limits of Tapie 2007 and, as at corners, the tolerance.</source>
        <translation>Chaque bloc est une impulsion de vitesse, réduite autour des angles jusqu’à ce que la tolérance de contour soit tenue&#xa0;; deux ou trois moyennes glissantes égales lissent les impulsions de chaque axe. Sur les arcs, que l’article ne traite pas, les impulsions suivent la tangente&#xa0;; elles gardent les limites statiques de Tapie 2007 et, comme aux angles, la tolérance.</translation>
    </message>
    <message>
        <source>Circular-arc blends at constant speed</source>
        <translation>Raccords en arc de cercle à vitesse constante</translation>
    </message>
    <message>
        <source>Tolerance share beta</source>
        <translation>Part bêta de la tolérance</translation>
    </message>
    <message>
        <source>Position gain Kv</source>
        <translation>Gain de position Kv</translation>
    </message>
    <message>
        <source>Velocity that the position loop of the axis asks for, over the following error: without feed-forward the axis stays v/Kv behind. Without a value the axis follows its set values exactly.</source>
        <translation>Vitesse que la boucle de position de l’axe demande, rapportée à l’écart de poursuite : sans anticipation, l’axe reste en retard de v/Kv. Sans valeur, l’axe suit exactement ses consignes.</translation>
    </message>
    <message>
        <source>Velocity feed-forward</source>
        <translation>Anticipation de vitesse</translation>
    </message>
    <message>
        <source>Share of the set velocity that the position loop adds to its own; with 1 there is no following error at constant velocity.</source>
        <translation>Part de la vitesse de consigne que la boucle de position ajoute à la sienne ; avec 1, il n’y a pas d’écart de poursuite à vitesse constante.</translation>
    </message>
    <message>
        <source>Lag of the velocity loop</source>
        <translation>Retard de la boucle de vitesse</translation>
    </message>
    <message>
        <source>Time constant with which the velocity loop of the axis reaches the velocity asked for; with feed-forward it makes circles grow with acceleration.</source>
        <translation>Constante de temps avec laquelle la boucle de vitesse de l’axe atteint la vitesse demandée ; avec l’anticipation, elle fait grandir les cercles avec l’accélération.</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Jeu à l’inversion</translation>
    </message>
    <message>
        <source>Distance that the motor of the axis turns back at a reversal before the slide moves.</source>
        <translation>Distance que le moteur de l’axe parcourt en arrière à une inversion avant que la table ne bouge.</translation>
    </message>
    <message>
        <source>Backlash compensation</source>
        <translation>Compensation du jeu</translation>
    </message>
    <message>
        <source>Share of the backlash that the control makes up for.</source>
        <translation>Part du jeu que la commande compense.</translation>
    </message>
    <message>
        <source>Friction spike</source>
        <translation>Pic de frottement</translation>
    </message>
    <message>
        <source>Distance by which friction holds the axis back when it reverses; on a circle it shows as a spike where quadrants change.</source>
        <translation>Distance dont le frottement retient l’axe quand il s’inverse ; sur un cercle, elle se voit comme un pic aux changements de quadrant.</translation>
    </message>
    <message>
        <source>Decay of the friction spike</source>
        <translation>Décroissance du pic de frottement</translation>
    </message>
    <message>
        <source>Time constant with which the friction spike decays.</source>
        <translation>Constante de temps avec laquelle le pic de frottement décroît.</translation>
    </message>
    <message>
        <source>Actual position of %1</source>
        <translation>Position réelle de %1</translation>
    </message>
    <message>
        <source>Following error of %1</source>
        <translation>Écart de poursuite de %1</translation>
    </message>
    <message>
        <source>Contour error of the actual path</source>
        <translation>Erreur de contour de la trajectoire réelle</translation>
    </message>
    <message>
        <source>contour error</source>
        <translation>erreur de contour</translation>
    </message>
    <message>
        <source>Following error across the path</source>
        <translation>Écart de poursuite normal à la trajectoire</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>Écart de poursuite</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Avance par dent</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Couple</translation>
    </message>
    <message>
        <source>Cutting power</source>
        <translation>Puissance de coupe</translation>
    </message>
    <message>
        <source>Mean cutting force</source>
        <translation>Effort de coupe moyen</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyen</translation>
    </message>
    <message>
        <source>Peak cutting force</source>
        <translation>Effort de coupe de crête</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>crête</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Épaisseur de copeau</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prévue</translation>
    </message>
    <message>
        <source>Chip thickness at the programmed feed</source>
        <translation>Épaisseur de copeau à l’avance programmée</translation>
    </message>
    <message>
        <source>at programmed feed</source>
        <translation>à l’avance programmée</translation>
    </message>
    <message>
        <source>Peak cutting force at the programmed feed</source>
        <translation>Effort de coupe de crête à l’avance programmée</translation>
    </message>
    <message>
        <source>peak at programmed feed</source>
        <translation>crête à l’avance programmée</translation>
    </message>
    <message>
        <source>Mean cutting force at the programmed feed</source>
        <translation>Effort de coupe moyen à l’avance programmée</translation>
    </message>
    <message>
        <source>Feed per tooth at the programmed feed</source>
        <translation>Avance par dent à l’avance programmée</translation>
    </message>
    <message>
        <source>Torque at the programmed feed</source>
        <translation>Couple à l’avance programmée</translation>
    </message>
    <message>
        <source>Cutting power at the programmed feed</source>
        <translation>Puissance de coupe à l’avance programmée</translation>
    </message>
    <message>
        <source>Actual error</source>
        <translation>Erreur réelle</translation>
    </message>
    <message>
        <source>Largest distance of the actual path from the programmed one</source>
        <translation>Plus grande distance de la trajectoire réelle à la trajectoire programmée</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Effort de crête</translation>
    </message>
    <message>
        <source>Largest peak cutting force</source>
        <translation>Plus grand effort de coupe de crête</translation>
    </message>
    <message>
        <source>Rubbing</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Time with chips below their least thickness</source>
        <translation>Temps avec des copeaux sous leur épaisseur minimale</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>Compresseur</translation>
    </message>
    <message>
        <source>Lays a smooth curve through dense short blocks within the contour tolerance, in place of a blend in every corner. program: where the program asks for it (COMPON, COMPCURV, COMPCAD, COMPSURF, CYCLE832, cycle 32, G05.1 Q1); off: never; on: everywhere. Our own curve: no maker publishes theirs.</source>
        <translation>Fait passer une courbe lisse par les blocs courts et denses, dans la tolérance de contour, au lieu d’un raccord à chaque angle. programme : là où le programme le demande (COMPON, COMPCURV, COMPCAD, COMPSURF, CYCLE832, cycle 32, G05.1 Q1) ; non : jamais ; oui : partout. Cette courbe est la nôtre : aucun fabricant ne publie la sienne.</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>Longest compressed block</source>
        <translation>Plus long bloc compressé</translation>
    </message>
    <message>
        <source>Longer lines stay lines; 20 is the value of a Sinumerik (MD20170) when it is new.</source>
        <translation>Les droites plus longues restent des droites ; 20 est la valeur d’une Sinumerik (MD20170) à la livraison.</translation>
    </message>
    <message>
        <source>Sharpest smoothed corner</source>
        <translation>Angle le plus vif à lisser</translation>
    </message>
    <message>
        <source>Corners that turn by more stay corners; 36 is the value of a Sinumerik (SD42470) when it is new.</source>
        <translation>Les angles qui tournent davantage restent des angles ; 36 est la valeur d’une Sinumerik (SD42470) à la livraison.</translation>
    </message>
    <message>
        <source>Compressor smoothing</source>
        <translation>Lissage du compresseur</translation>
    </message>
    <message>
        <source>How much waves of the points are damped, in spans of the curve; 0: only by the length of its spans. Assumed: no maker gives a number.</source>
        <translation>Amortissement des ondulations des points, en tronçons de la courbe ; 0 : seulement par la longueur de ses tronçons. Supposé : aucun fabricant ne donne de nombre.</translation>
    </message>
    <message>
        <source>Blocks shorter than this are merged into segments of at most this length where the tolerance allows it; 0: no compaction. Where the compressor is at work it takes the place of this.</source>
        <translation>Les blocs plus courts sont réunis en segments d’au plus cette longueur là où la tolérance le permet ; 0 : pas de compactage. Là où le compresseur agit, il le remplace.</translation>
    </message>
    <message>
        <source>junction deviation</source>
        <translation>écart de jonction (junction deviation)</translation>
    </message>
    <message>
        <source>square corner velocity</source>
        <translation>vitesse dans un angle de 90° (square corner velocity)</translation>
    </message>
    <message>
        <source>minimum cruise ratio</source>
        <translation>part minimale à vitesse constante</translation>
    </message>
    <message>
        <source>kink between blocks</source>
        <translation>cassure entre blocs</translation>
    </message>
    <message>
        <source>velocity along the path</source>
        <translation>vitesse le long de la trajectoire</translation>
    </message>
    <message>
        <source>acceleration along the path</source>
        <translation>accélération le long de la trajectoire</translation>
    </message>
    <message>
        <source>Step resolution</source>
        <translation>Résolution des pas</translation>
    </message>
    <message>
        <source>Steps of the motor over 1 mm of the axis: controls of stepper motors round the ends of blocks to whole steps. Without a value they are not rounded.</source>
        <translation>Pas du moteur pour 1 mm de l’axe : les commandes de moteurs pas à pas arrondissent les fins de bloc à des pas entiers. Sans valeur, elles ne sont pas arrondies.</translation>
    </message>
    <message>
        <source>Refuse lines</source>
        <translation>Refuser des lignes</translation>
    </message>
    <message>
        <source>on: lines that the control rejects are reported and not run; off: they are run as they are meant.</source>
        <translation>on : les lignes que la commande rejette sont signalées et ne sont pas exécutées ; off : elles sont exécutées comme elles sont voulues.</translation>
    </message>
    <message>
        <source>Junction deviation</source>
        <translation>Écart de jonction (junction deviation)</translation>
    </message>
    <message>
        <source>$11 of grbl: how far an arc in a corner might leave it; the speed that such an arc would allow is that of the corner, which itself is run as programmed.</source>
        <translation>$11 de grbl : de combien un arc dans un angle pourrait s’en écarter ; la vitesse que permettrait un tel arc est celle de l’angle, qui est lui-même suivi tel qu’il est programmé.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolérance des arcs</translation>
    </message>
    <message>
        <source>$12 of grbl: how far the chords that arcs are cut into may leave them.</source>
        <translation>$12 de grbl : de combien les cordes des arcs peuvent s’en écarter.</translation>
    </message>
    <message>
        <source>Planner buffer</source>
        <translation>File de blocs</translation>
    </message>
    <message>
        <source>Blocks that are planned together, the running one included; the last of them always ends at rest.</source>
        <translation>Blocs planifiés ensemble, celui en cours compris ; le dernier se termine toujours à l’arrêt.</translation>
    </message>
    <message>
        <source>Idle delay</source>
        <translation>Maintien à l’arrêt</translation>
    </message>
    <message>
        <source>$1 of grbl: time for which the motors hold each time all motion ends.</source>
        <translation>$1 de grbl : temps pendant lequel les moteurs restent bloqués chaque fois que tout mouvement cesse.</translation>
    </message>
    <message>
        <source>Step timing</source>
        <translation>Durée des pas</translation>
    </message>
    <message>
        <source>on: times as the step timer makes them, with whole steps and whole timer counts, where steps per mm are given; off: as planned.</source>
        <translation>on : durées telles que les fait le compteur de pas, en pas entiers et en impulsions entières, si les pas par mm sont donnés ; off : durées planifiées.</translation>
    </message>
    <message>
        <source>Open control grbl</source>
        <translation>Commande ouverte grbl</translation>
    </message>
    <message>
        <source>Corners are passed at the speed that the junction deviation allows, with constant acceleration and no limit of the jerk; arcs are cut into chords. The control plans 15 blocks ahead and must be able to stop within them, so that short blocks are slow. Lines that it does not understand are not run.</source>
        <translation>Les angles sont passés à la vitesse que permet l’écart de jonction, à accélération constante et sans limite du jerk ; les arcs sont coupés en cordes. La commande planifie 15 blocs d’avance et doit pouvoir s’y arrêter, si bien que les blocs courts sont lents. Les lignes qu’elle ne comprend pas ne sont pas exécutées.</translation>
    </message>
    <message>
        <source>Maximum velocity</source>
        <translation>Vitesse maximale</translation>
    </message>
    <message>
        <source>max_velocity of Klipper: of the tool along the path. Without a value the least of the axes.</source>
        <translation>max_velocity de Klipper : de l’outil le long de la trajectoire. Sans valeur, la plus petite des axes.</translation>
    </message>
    <message>
        <source>Maximum acceleration</source>
        <translation>Accélération maximale</translation>
    </message>
    <message>
        <source>max_accel of Klipper: of the tool along the path. Without a value the least of the axes.</source>
        <translation>max_accel de Klipper : de l’outil le long de la trajectoire. Sans valeur, la plus petite des axes.</translation>
    </message>
    <message>
        <source>Square corner velocity</source>
        <translation>Vitesse dans un angle de 90°</translation>
    </message>
    <message>
        <source>Speed at which the tool may pass a corner of 90 degrees; other corners accordingly.</source>
        <translation>Vitesse à laquelle l’outil peut passer un angle de 90 degrés ; les autres angles en proportion.</translation>
    </message>
    <message>
        <source>Minimum cruise ratio</source>
        <translation>Part minimale à vitesse constante</translation>
    </message>
    <message>
        <source>Part of a way between two slow places that is left for constant speed, so that short zigzags do not accelerate all the time.</source>
        <translation>Part d’un trajet entre deux endroits lents qui reste à vitesse constante, pour que de courts zigzags n’accélèrent pas sans cesse.</translation>
    </message>
    <message>
        <source>Arc resolution</source>
        <translation>Résolution des arcs</translation>
    </message>
    <message>
        <source>Length of the chords that arcs are cut into.</source>
        <translation>Longueur des cordes en lesquelles les arcs sont coupés.</translation>
    </message>
    <message>
        <source>Maximum velocity of Z</source>
        <translation>Vitesse maximale de Z</translation>
    </message>
    <message>
        <source>Maximum velocity of the extruder alone</source>
        <translation>Vitesse maximale de l’extrudeur seul</translation>
    </message>
    <message>
        <source>max_extrude_only_velocity of Klipper. Without a value that for a nozzle of 0.4 mm and a filament of 1.75 mm: 0.27 times that along the path.</source>
        <translation>max_extrude_only_velocity de Klipper. Sans valeur, celle d’une buse de 0,4 mm et d’un filament de 1,75 mm&#xa0;: 0,27 fois celle le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Without a value that along the path.</source>
        <translation>Sans valeur, celle de la trajectoire.</translation>
    </message>
    <message>
        <source>Maximum acceleration of Z</source>
        <translation>Accélération maximale de Z</translation>
    </message>
    <message>
        <source>Maximum acceleration of the extruder alone</source>
        <translation>Accélération maximale de l’extrudeur seul</translation>
    </message>
    <message>
        <source>max_extrude_only_accel of Klipper. Without a value that for a nozzle of 0.4 mm and a filament of 1.75 mm: 0.27 times that along the path.</source>
        <translation>max_extrude_only_accel de Klipper. Sans valeur, celle d’une buse de 0,4 mm et d’un filament de 1,75 mm&#xa0;: 0,27 fois celle le long de la trajectoire.</translation>
    </message>
    <message>
        <source>Open control Klipper</source>
        <translation>Commande ouverte Klipper</translation>
    </message>
    <message>
        <source>Velocity and acceleration are limited along the path; corners are passed as they are programmed, at a speed that the square corner velocity sets, without any limit of the jerk. The look-ahead has no end, and a part of every way is kept for constant speed. Every line must begin with its command.</source>
        <translation>Vitesse et accélération sont limitées le long de la trajectoire ; les angles sont passés tels qu’ils sont programmés, à une vitesse que fixe la vitesse dans un angle de 90°, sans limite du jerk. L’anticipation est sans fin, et une part de chaque trajet reste à vitesse constante. Chaque ligne doit commencer par sa commande.</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificateur</translation>
    </message>
    <message>
        <source>Version of LinuxCNC. 2.9 gives the last move of a program and one that stands alone half of the acceleration under G64; master gives them all of it, but limits arcs more.</source>
        <translation>Version de LinuxCNC. Sous G64, 2.9 ne donne que la moitié de l’accélération au dernier déplacement d’un programme et à un déplacement isolé ; master la leur donne toute, mais limite davantage les arcs.</translation>
    </message>
    <message>
        <source>Path control mode</source>
        <translation>Mode de suivi de trajectoire</translation>
    </message>
    <message>
        <source>Blend tolerance</source>
        <translation>Tolérance de raccord</translation>
    </message>
    <message>
        <source>P of G64 where the program gives none: how far blends may leave the corner. 0: as far as a quarter of the blocks, as fast as possible.</source>
        <translation>P de G64 quand le programme n’en donne pas : de combien les raccords peuvent s’écarter de l’angle. 0 : jusqu’au quart des blocs, aussi vite que possible.</translation>
    </message>
    <message>
        <source>Naive CAM tolerance</source>
        <translation>Tolérance du détecteur FAO (naive CAM)</translation>
    </message>
    <message>
        <source>Q of G64 where the program gives none: blocks whose ends lie within it of a line become one block. 0: none do. Without a value the blend tolerance.</source>
        <translation>Q de G64 quand le programme n’en donne pas : les blocs dont les fins s’écartent d’une droite de moins que cela deviennent un seul bloc. 0 : aucun. Sans valeur, la tolérance de raccord.</translation>
    </message>
    <message>
        <source>Servo period</source>
        <translation>Période d’asservissement</translation>
    </message>
    <message>
        <source>SERVO_PERIOD: time of one step of the planner, which takes one block at most from the program in each.</source>
        <translation>SERVO_PERIOD : durée d’un pas du planificateur, qui prend au plus un bloc du programme à chaque pas.</translation>
    </message>
    <message>
        <source>Maximum linear velocity</source>
        <translation>Vitesse linéaire maximale</translation>
    </message>
    <message>
        <source>MAX_LINEAR_VELOCITY: of the tool along the path. Without a value only the axes limit it.</source>
        <translation>MAX_LINEAR_VELOCITY : de l’outil le long de la trajectoire. Sans valeur, seuls les axes la limitent.</translation>
    </message>
    <message>
        <source>Maximum feed override</source>
        <translation>Correction d’avance maximale</translation>
    </message>
    <message>
        <source>MAX_FEED_OVERRIDE: up to where the operator may raise the feed; blends are laid for that speed. The program runs at 100 %.</source>
        <translation>MAX_FEED_OVERRIDE : jusqu’où l’opérateur peut monter l’avance ; les raccords sont faits pour cette vitesse. Le programme tourne à 100 %.</translation>
    </message>
    <message>
        <source>Open control LinuxCNC</source>
        <translation>Commande ouverte LinuxCNC</translation>
    </message>
    <message>
        <source>Every servo period the planner computes the next place, with constant acceleration and no limit of the jerk. Under G64 arcs within the tolerance blend corners, or neighbours overlap, and short blocks along a line become one; under G61 corners are exact stops. Half of the acceleration is kept back for blends.</source>
        <translation>À chaque période d’asservissement, le planificateur calcule le prochain point, à accélération constante et sans limite de jerk. Sous G64, des arcs raccordent les angles dans la tolérance, ou deux blocs se chevauchent, et les blocs courts le long d’une droite n’en font qu’un ; sous G61, les angles sont des arrêts précis. La moitié de l’accélération est réservée aux raccords.</translation>
    </message>
    <message>
        <source>parameters of a Fanuc</source>
        <translation>paramètres d’une Fanuc</translation>
    </message>
    <message>
        <source>listing of grbl settings</source>
        <translation>liste de réglages de grbl</translation>
    </message>
    <message>
        <source>machine parameters of a Heidenhain</source>
        <translation>paramètres machine d’une Heidenhain</translation>
    </message>
    <message>
        <source>configuration of Klipper</source>
        <translation>configuration de Klipper</translation>
    </message>
    <message>
        <source>INI file of LinuxCNC</source>
        <translation>fichier INI de LinuxCNC</translation>
    </message>
    <message>
        <source>listing of Marlin settings</source>
        <translation>liste de réglages de Marlin</translation>
    </message>
    <message>
        <source>machine data of a Sinumerik</source>
        <translation>paramètres machine d’une Sinumerik</translation>
    </message>
    <message>
        <source>Moves the points of dense short blocks onto a smooth curve, within a tenth of the contour tolerance, before the pulses are made. program: where the program asks for it; off: never; on: everywhere. Our own addition: the filters smooth by themselves, and no time is gained by it.</source>
        <translation>Déplace les points des blocs courts et serrés sur une courbe lisse, à moins d’un dixième de la tolérance de contour, avant la formation des impulsions. program : là où le programme le demande ; off : jamais ; on : partout. Ajout de Feedscope : les filtres lissent d’eux-mêmes, aucun temps n’est gagné.</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>angles</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>arcs</source>
        <translation>arcs</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>droites</translation>
    </message>
    <message>
        <source>block length</source>
        <translation>longueur de bloc</translation>
    </message>
    <message>
        <source>smooth curves</source>
        <translation>courbes lissées</translation>
    </message>
    <message>
        <source>rapids</source>
        <translation>rapides</translation>
    </message>
    <message>
        <source>starts and stops</source>
        <translation>départs et arrêts</translation>
    </message>
    <message>
        <source>feed motions</source>
        <translation>déplacements en avance</translation>
    </message>
    <message>
        <source>dwells</source>
        <translation>temporisations</translation>
    </message>
    <message>
        <source>tool changes</source>
        <translation>changements d’outil</translation>
    </message>
    <message>
        <source>spindle starts</source>
        <translation>démarrages de broche</translation>
    </message>
    <message>
        <source>No jerk is limited: the acceleration jumps, and where blocks meet the velocity of an axis, too. There is no largest jerk, and the largest accelerations are those between the jumps.</source>
        <translation>Le jerk n’est pas limité : l’accélération saute et, là où les blocs se rejoignent, la vitesse d’un axe aussi. Il n’y a pas de jerk maximal, et les accélérations maximales sont celles entre les sauts.</translation>
    </message>
    <message>
        <source>Velocity, acceleration and jerk of the axis, from rest to rest.</source>
        <translation>Vitesse, accélération et jerk de l’axe, d’un arrêt à l’autre.</translation>
    </message>
    <message>
        <source>Velocity, acceleration and jerk of Z.</source>
        <translation>Vitesse, accélération et jerk de Z.</translation>
    </message>
    <message>
        <source>Acceleration and jerk along the path at speed.</source>
        <translation>Accélération et jerk le long du trajet, en marche.</translation>
    </message>
    <message>
        <source>Speed through a corner over its angle: tolerance or corner rule, and how far the control leaves the corner.</source>
        <translation>Vitesse dans un angle selon sa valeur : tolérance ou règle d’angle, et de combien la commande s’écarte de l’angle.</translation>
    </message>
    <message>
        <source>Acceleration and jerk across the path, by radius.</source>
        <translation>Accélération et jerk en travers du trajet, selon le rayon.</translation>
    </message>
    <message>
        <source>Look-ahead, smoothing of points and time by block.</source>
        <translation>Anticipation, lissage des points et temps par bloc.</translation>
    </message>
    <message>
        <source>The model does not explain the traces: a value of it would say nothing of the machine.</source>
        <translation>Le modèle n’explique pas les traces : une de ses valeurs ne dirait rien de la machine.</translation>
    </message>
    <message>
        <source>It changes nothing that these traces show.</source>
        <translation>Elle ne change rien à ce que montrent ces traces.</translation>
    </message>
    <message>
        <source>These traces never reach it: larger values show the same.</source>
        <translation>Ces traces ne l’atteignent jamais : de plus grandes valeurs montrent la même chose.</translation>
    </message>
    <message>
        <source>These traces show the same with smaller values.</source>
        <translation>Ces traces montrent la même chose avec de plus petites valeurs.</translation>
    </message>
    <message>
        <source>One place of these traces alone speaks for it, where something else may limit.</source>
        <translation>Un seul endroit de ces traces parle pour elle, où autre chose peut limiter.</translation>
    </message>
    <message>
        <source>It cannot be told apart from the others by these traces.</source>
        <translation>Ces traces ne permettent pas de la distinguer des autres.</translation>
    </message>
    <message>
        <source>slowing for a lower programmed feed</source>
        <translation>ralentissement vers une avance programmée plus faible</translation>
    </message>
    <message>
        <source>Maximum velocity of this rotary axis.</source>
        <translation>Vitesse maximale de cet axe rotatif.</translation>
    </message>
    <message>
        <source>Maximum acceleration of this rotary axis.</source>
        <translation>Accélération maximale de cet axe rotatif.</translation>
    </message>
    <message>
        <source>Maximum rate of change of the acceleration of this rotary axis.</source>
        <translation>Vitesse de variation maximale de l’accélération de cet axe rotatif.</translation>
    </message>
    <message>
        <source>Minimum position</source>
        <translation>Position minimale</translation>
    </message>
    <message>
        <source>Lower end of the travel of this rotary axis; without it the axis has no end.</source>
        <translation>Extrémité inférieure de la course de cet axe rotatif ; sans elle, l’axe tourne sans fin.</translation>
    </message>
    <message>
        <source>Maximum position</source>
        <translation>Position maximale</translation>
    </message>
    <message>
        <source>Upper end of the travel of this rotary axis; without it the axis has no end.</source>
        <translation>Extrémité supérieure de la course de cet axe rotatif ; sans elle, l’axe tourne sans fin.</translation>
    </message>
    <message>
        <source>same motions, same feed</source>
        <translation>mêmes mouvements, même avance</translation>
    </message>
    <message>
        <source>same motions, other feed</source>
        <translation>mêmes mouvements, autre avance</translation>
    </message>
    <message>
        <source>other motions</source>
        <translation>autres mouvements</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>supprimé</translation>
    </message>
    <message>
        <source>added</source>
        <translation>ajouté</translation>
    </message>
    <message>
        <source>indexing of rotary axes</source>
        <translation>positionnement des axes rotatifs</translation>
    </message>
    <message>
        <source>indexing of axis %1</source>
        <translation>positionnement de l’axe %1</translation>
    </message>
    <message>
        <source>Where the program gives none: G64 blends corners within the blend tolerance, G61 stops where blocks do not join tangentially, G61.1 at the end of every block.</source>
        <translation>Quand le programme n’en donne pas : G64 raccorde les angles dans la tolérance de raccord, G61 s’arrête là où les blocs ne se suivent pas tangentiellement, G61.1 à la fin de chaque bloc.</translation>
    </message>
    <message>
        <source>table of samples</source>
        <translation>tableau d’échantillons</translation>
    </message>
    <message>
        <source>exact stops</source>
        <translation>arrêts précis</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>continu</translation>
    </message>
    <message>
        <source>compaction on</source>
        <translation>compactage activé</translation>
    </message>
    <message>
        <source>compaction off</source>
        <translation>compactage désactivé</translation>
    </message>
    <message>
        <source>smooth curves on</source>
        <translation>courbes lissées activées</translation>
    </message>
    <message>
        <source>smooth curves off</source>
        <translation>courbes lissées désactivées</translation>
    </message>
    <message>
        <source>feed forward on</source>
        <translation>anticipation de vitesse activée</translation>
    </message>
    <message>
        <source>feed forward off</source>
        <translation>anticipation de vitesse désactivée</translation>
    </message>
    <message>
        <source>look-ahead on</source>
        <translation>anticipation de blocs activée</translation>
    </message>
    <message>
        <source>look-ahead off</source>
        <translation>anticipation de blocs désactivée</translation>
    </message>
    <message>
        <source>jerk limited</source>
        <translation>jerk limité</translation>
    </message>
    <message>
        <source>acceleration in steps</source>
        <translation>accélération par échelons</translation>
    </message>
    <message>
        <source>acceleration falling with speed</source>
        <translation>accélération décroissante avec la vitesse</translation>
    </message>
    <message>
        <source>as the machine</source>
        <translation>comme la machine</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grossier</translation>
    </message>
    <message>
        <source>interpolation end</source>
        <translation>fin d’interpolation</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by arcs about one centre. Circles of short lines are not recognised.</source>
        <translation>Le programme ne contient aucun cercle complet&#xa0;: aucune passe ne fait un tour entier en XY, ZX ou YZ par des arcs de même centre. Les cercles en petits segments ne sont pas reconnus.</translation>
    </message>
    <message>
        <source>Not evaluated: 1 helix with full turns.</source>
        <translation>Non évalué&#xa0;: 1 hélice à tours complets.</translation>
    </message>
    <message>
        <source>Not evaluated: 1 full circle outside the planes XY, ZX and YZ.</source>
        <translation>Non évalué&#xa0;: 1 cercle complet hors des plans XY, ZX et YZ.</translation>
    </message>
    <message>
        <source>The source covers lines and their corners; arcs and helices follow the shared rules.</source>
        <translation>La source traite les droites et leurs angles&#xa0;; arcs et hélices suivent les règles communes.</translation>
    </message>
    <message>
        <source>The source covers arcs; lines follow the shared rules.</source>
        <translation>La source traite les arcs&#xa0;; les droites suivent les règles communes.</translation>
    </message>
    <message>
        <source>The programmed path is followed by straight blocks, arcs by chords within the arc tolerance; no corner is blended. Ends of blocks are rounded to whole steps of the axes.</source>
        <translation>La trajectoire programmée est suivie en blocs droits, les arcs par des cordes dans la tolérance d’arc&#xa0;; aucun angle n’est raccordé. Les fins de bloc sont arrondies à des pas entiers des axes.</translation>
    </message>
    <message>
        <source>The programmed path is followed by straight blocks, arcs by chords; no corner is blended.</source>
        <translation>La trajectoire programmée est suivie en blocs droits, les arcs par des cordes&#xa0;; aucun angle n’est raccordé.</translation>
    </message>
    <message>
        <source>The programmed path is followed exactly; no corner is blended.</source>
        <translation>La trajectoire programmée est suivie exactement&#xa0;; aucun angle n’est raccordé.</translation>
    </message>
    <message>
        <source>The distance of programmed corners from the path is not bounded.</source>
        <translation>La distance des angles programmés à la trajectoire n’est pas bornée.</translation>
    </message>
    <message>
        <source>The distance of programmed corners from the path is not bounded; tangent transitions between blocks are passed exactly.</source>
        <translation>La distance des angles programmés à la trajectoire n’est pas bornée&#xa0;; les transitions tangentes entre blocs sont suivies exactement.</translation>
    </message>
    <message>
        <source>Every programmed corner lies within the contour tolerance of the path.</source>
        <translation>Chaque angle programmé est à moins de la tolérance de contour de la trajectoire.</translation>
    </message>
    <message>
        <source>Every programmed corner lies within the contour tolerance of the path; tangent transitions between blocks are passed exactly.</source>
        <translation>Chaque angle programmé est à moins de la tolérance de contour de la trajectoire&#xa0;; les transitions tangentes entre blocs sont suivies exactement.</translation>
    </message>
    <message>
        <source>The programmed feed is kept along every block; where two blocks overlap their speeds add.</source>
        <translation>L’avance programmée est tenue dans chaque bloc&#xa0;; là où deux blocs se chevauchent, leurs vitesses s’ajoutent.</translation>
    </message>
    <message>
        <source>The programmed feed is met to whole steps and counts of a timer; very slow feeds are exceeded.</source>
        <translation>L’avance programmée est tenue au pas entier et au tic de minuterie près&#xa0;; les avances très lentes sont dépassées.</translation>
    </message>
    <message>
        <source>the largest programmed feed between two standstills</source>
        <translation>la plus grande avance programmée entre deux arrêts</translation>
    </message>
    <message>
        <source>the programmed feed</source>
        <translation>l’avance programmée</translation>
    </message>
    <message>
        <source>the limit</source>
        <translation>la limite</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>jerk</source>
        <translation>jerk</translation>
    </message>
    <message>
        <source>jerk (blend_jerk)</source>
        <translation>jerk (blend_jerk)</translation>
    </message>
    <message>
        <source>The speed jumps along the path.</source>
        <translation>La vitesse saute le long de la trajectoire.</translation>
    </message>
    <message>
        <source>The speed is continuous; the acceleration jumps where the curvature of the path does.</source>
        <translation>La vitesse est continue&#xa0;; l’accélération saute là où saute la courbure de la trajectoire.</translation>
    </message>
    <message>
        <source>Velocity and acceleration are continuous everywhere.</source>
        <translation>Vitesse et accélération sont continues partout.</translation>
    </message>
    <message>
        <source>Where the program asks for BRISK, no jerk along the path is bounded: its acceleration changes within one interpolation period.</source>
        <translation>Là où le programme demande BRISK, aucun jerk n’est borné le long de la trajectoire&#xa0;: l’accélération y change en une période d’interpolation.</translation>
    </message>
    <message>
        <source>BRISK of the program is not followed.</source>
        <translation>Le BRISK du programme n’est pas suivi.</translation>
    </message>
    <message>
        <source>A junction that touches an arc and turns by up to 0.01 rad is passed as if it were tangent: there the velocity of an axis jumps by up to 1 % of the feed (1 mm/s at 6000 mm/min).</source>
        <translation>Une jonction qui touche un arc et tourne d’au plus 0,01 rad est franchie comme si elle était tangente&#xa0;: la vitesse d’un axe y saute d’au plus 1&#xa0;% de l’avance (1 mm/s à 6000 mm/min).</translation>
    </message>
    <message>
        <source>Full stops at dwells only.</source>
        <translation>Arrêts complets aux seules temporisations.</translation>
    </message>
    <message>
        <source>at corners of lines</source>
        <translation>aux angles entre droites</translation>
    </message>
    <message>
        <source>at corners that touch an arc</source>
        <translation>aux angles qui touchent un arc</translation>
    </message>
    <message>
        <source>at reversals</source>
        <translation>aux rebroussements</translation>
    </message>
    <message>
        <source>before and after every rapid</source>
        <translation>avant et après chaque rapide</translation>
    </message>
    <message>
        <source>On blends that nearly reverse, limits were exceeded by up to 5 % (acceleration) and a third (jerk).</source>
        <translation>Sur des raccords proches du rebroussement, des dépassements de limite jusqu’à 5&#xa0;% (accélération) et un tiers (jerk) ont été relevés.</translation>
    </message>
    <message>
        <source>On the path of ward, jerk=on keeps the jerk except for short peaks where an arc begins from a standstill.</source>
        <translation>Sur la trajectoire de ward, jerk=on tient le jerk, sauf de courtes pointes là où un arc part de l’arrêt.</translation>
    </message>
    <message>
        <source>Stops only where the path itself has a kink, a reversal or a dwell.</source>
        <translation>Ne s’arrête que là où la trajectoire elle-même a une cassure, un rebroussement ou une temporisation.</translation>
    </message>
    <message>
        <source>Kinks of up to 0.01 rad at arcs are treated as tangent, as in every model.</source>
        <translation>Les cassures d’au plus 0,01 rad aux arcs sont traitées comme tangentes, comme dans tous les modèles.</translation>
    </message>
    <message>
        <source>A rapid keeps the velocity limit of every axis.</source>
        <translation>Un rapide tient la limite de vitesse de chaque axe.</translation>
    </message>
    <message>
        <source>reading corrected, published: at the entry of a blend the radial shares of acceleration and jerk are kept. Further on, with equal axes and shares of 0.2, the acceleration stays within 1.01 and the jerk within 2.2 times the limit; the curvature grows up to five times, and other axes bear it.</source>
        <translation>lecture corrected, published&#xa0;: à l’entrée d’un raccord, les parts radiales de l’accélération et du jerk sont tenues. Plus loin, avec des axes égaux et des parts de 0,2, l’accélération reste à moins de 1,01 fois la limite et le jerk à moins de 2,2 fois&#xa0;; la courbure croît jusqu’à cinq fois, et d’autres axes la supportent.</translation>
    </message>
    <message>
        <source>On blends the shares of the least acceleration and jerk of the axes are kept: of the acceleration R_A across and 1 - R_A along the path, of the jerk R_J across and 1 - R_J along it.</source>
        <translation>Sur les raccords, les parts de la plus petite accélération et du plus petit jerk des axes sont tenues&#xa0;: de l’accélération, R_A normalement à la trajectoire et 1 - R_A le long d’elle&#xa0;; du jerk, R_J normalement et 1 - R_J le long.</translation>
    </message>
    <message>
        <source>No jerk is limited, and in corners the velocity of an axis jumps.</source>
        <translation>Aucun jerk n’est limité et, dans les angles, la vitesse d’un axe saute.</translation>
    </message>
    <message>
        <source>Corners between rapids and feed motions follow the rule of all corners; the tool does not stop there.</source>
        <translation>Les angles entre rapides et avances suivent la règle de tous les angles ; l’outil ne s’y arrête pas.</translation>
    </message>
    <message>
        <source>Rapids are lines at the feed in force; those of a program that is run as it is meant run at the maximum velocity.</source>
        <translation>Les rapides sont des droites à l’avance en vigueur&#xa0;; ceux d’un programme exécuté tel qu’il est pensé vont à la vitesse maximale.</translation>
    </message>
    <message>
        <source>No jerk is limited, and where blocks meet within a small kink the velocity of an axis jumps.</source>
        <translation>Aucun jerk n’est limité et, là où des blocs se rejoignent avec une petite cassure, la vitesse d’un axe saute.</translation>
    </message>
    <message>
        <source>The time runs from the first to the last motion: a dwell before or after all of it is not counted.</source>
        <translation>Le temps court du premier au dernier mouvement&#xa0;: une temporisation avant ou après n’est pas comptée.</translation>
    </message>
    <message>
        <source>Rapids blend among each other; next to a feed motion they stop.</source>
        <translation>Les rapides se raccordent entre eux&#xa0;; à côté d’un déplacement en avance, ils s’arrêtent.</translation>
    </message>
    <message>
        <source>Points that compaction omits stay within the tolerance of the chord; a corner blend may deviate from the chord in addition.</source>
        <translation>Les points que le compactage supprime restent à moins de la tolérance de la corde&#xa0;; un raccord d’angle peut s’écarter de la corde en plus.</translation>
    </message>
    <message>
        <source>law dynamic: where curvature jumps, the acceleration changes within one interpolation period by what the axis jerk allows.</source>
        <translation>loi dynamic&#xa0;: là où la courbure saute, l’accélération change en une période d’interpolation de ce que permet le jerk de l’axe.</translation>
    </message>
    <message>
        <source>On arcs the tangential and the radial acceleration each keep the axis limits at the place where the steady feed is reached, and so do the two parts of the jerk along the path, v&apos;&apos; and v^3 k^2; their sum may exceed them, and elsewhere on the arc the radial acceleration and v^3 k^2 too, as measured there.</source>
        <translation>Sur les arcs, l’accélération tangentielle et l’accélération radiale tiennent chacune les limites des axes à l’endroit où l’avance stable est atteinte, de même que les deux parts du jerk le long de la trajectoire, v&apos;&apos; et v^3 k^2&#xa0;; leur somme peut les dépasser et, ailleurs sur l’arc, l’accélération radiale et v^3 k^2 aussi, selon ce qui y est mesuré.</translation>
    </message>
    <message>
        <source>A filtered velocity is an average of commanded ones, which keeps the axes&apos; velocities.</source>
        <translation>Une vitesse filtrée est une moyenne de vitesses de consigne&#xa0;: les vitesses des axes sont tenues.</translation>
    </message>
    <message>
        <source>Acceleration and jerk follow from the filters alone: a change of feed dF takes the jerk dF/T1^2; axis limits are not considered.</source>
        <translation>Accélération et jerk ne viennent que des filtres&#xa0;: un changement d’avance dF demande le jerk dF/T1^2&#xa0;; les limites des axes ne sont pas prises en compte.</translation>
    </message>
    <message>
        <source>With three filters the jerk is continuous, too.</source>
        <translation>Avec trois filtres, le jerk est continu lui aussi.</translation>
    </message>
    <message>
        <source>Tolerance 0: full stops in every corner; on arcs the path is still inside the programmed one, by the amount that the filters reduce the radius.</source>
        <translation>Tolérance 0&#xa0;: arrêt complet à chaque angle&#xa0;; sur les arcs, la trajectoire reste à l’intérieur de la trajectoire programmée, de ce dont les filtres réduisent le rayon.</translation>
    </message>
    <message>
        <source>info</source>
        <translation>information</translation>
    </message>
    <message>
        <source>open the program that was recorded, or give the zero point it ran with; times and feeds of the two tell nothing together</source>
        <translation>ouvrir le programme enregistré, ou indiquer l’origine avec laquelle il a tourné&#xa0;; les temps et les avances des deux ne disent rien ensemble</translation>
    </message>
    <message>
        <source>the trace does not move</source>
        <translation>la trace ne bouge pas</translation>
    </message>
    <message>
        <source>record while the program runs, and check the columns of the positions</source>
        <translation>enregistrer pendant que le programme tourne, et vérifier les colonnes des positions</translation>
    </message>
    <message>
        <source>the trace is in inches; it is used as 25.4 times what it says</source>
        <translation>la trace est en pouces&#xa0;; ses valeurs sont multipliées par 25,4</translation>
    </message>
    <message>
        <source>give its columns the unit, as --columns x=2:in, where that is right</source>
        <translation>si c’est exact, donner l’unité à ses colonnes, comme --columns x=2:in</translation>
    </message>
    <message>
        <source>the trace is 25.4 times as large as the program; it is used as that part of it</source>
        <translation>la trace est 25,4 fois plus grande que le programme&#xa0;; ses valeurs sont divisées par 25,4</translation>
    </message>
    <message>
        <source>its positions are in mm, not in inches: say so, as --columns x=2:mm, where that is right</source>
        <translation>ses positions sont en mm et non en pouces&#xa0;: si c’est exact, l’indiquer, comme --columns x=2:mm</translation>
    </message>
    <message>
        <source>give its column a minus sign, as --columns x=2:-mm, where that is right</source>
        <translation>si c’est exact, donner un signe moins à sa colonne, comme --columns x=2:-mm</translation>
    </message>
    <message>
        <source>if it was not recorded, name the columns of the others alone, as --columns time=1,x=2: times and the motion of these axes can be compared then</source>
        <translation>s’il n’a pas été enregistré, ne nommer que les colonnes des autres, comme --columns time=1,x=2&#xa0;: les temps et le mouvement de ces axes peuvent alors être comparés</translation>
    </message>
    <message>
        <source>times and limits of the axes that are there can be told; record X, Y and Z for the others</source>
        <translation>les temps et les limites des axes présents peuvent être déterminés&#xa0;; enregistrer X, Y et Z pour les autres</translation>
    </message>
    <message>
        <source>they are marked and their feeds not compared; the control did there what the program does not say</source>
        <translation>ils sont marqués et leurs avances ne sont pas comparées&#xa0;; la commande y a fait ce que le programme ne dit pas</translation>
    </message>
    <message>
        <source>the time of the whole is right; feeds, ramps and corners there are not known</source>
        <translation>le temps de l’ensemble est juste&#xa0;; avances, rampes et angles y sont inconnus</translation>
    </message>
    <message>
        <source>feeds, ramps and corners there can be compared and limits be told; the cycle time is not known</source>
        <translation>avances, rampes et angles de cette partie peuvent être comparés et des limites déterminées&#xa0;; le temps de cycle est inconnu</translation>
    </message>
    <message>
        <source>the run does not follow the path of the program within the tolerance of the comparison</source>
        <translation>la simulation ne suit pas la trajectoire du programme dans la tolérance de la comparaison</translation>
    </message>
    <message>
        <source>trace and run have no part of the path in common</source>
        <translation>la trace et la simulation n’ont aucune partie de la trajectoire en commun</translation>
    </message>
    <message>
        <source>only the longest part between two such places is used</source>
        <translation>seule la partie la plus longue entre deux de ces endroits est utilisée</translation>
    </message>
    <message>
        <source>record one run in one trace</source>
        <translation>enregistrer une seule exécution par trace</translation>
    </message>
    <message>
        <source>signals recorded at one rate need none</source>
        <translation>des signaux enregistrés à une même cadence n’en ont pas besoin</translation>
    </message>
    <message>
        <source>what happened there is not known; ramps and corners there tell nothing</source>
        <translation>ce qui s’y est passé est inconnu&#xa0;; rampes et angles n’y disent rien</translation>
    </message>
    <message>
        <source>record less signals, or at a lower rate</source>
        <translation>enregistrer moins de signaux, ou à une cadence plus basse</translation>
    </message>
    <message>
        <source>times are used as they stand</source>
        <translation>les temps sont utilisés tels quels</translation>
    </message>
    <message>
        <source>record at 1 to 4 ms; times and velocities of long moves are right as it is</source>
        <translation>enregistrer toutes les 1 à 4 ms&#xa0;; les temps et les vitesses des longs déplacements sont justes ainsi</translation>
    </message>
    <message>
        <source>remove rows that are not data, or check the columns</source>
        <translation>retirer ce qui n’est pas un tableau, ou vérifier les colonnes</translation>
    </message>
    <message>
        <source>record the time with more digits</source>
        <translation>enregistrer le temps avec plus de chiffres</translation>
    </message>
    <message>
        <source>the table has no head: what its columns are is judged by their values</source>
        <translation>le tableau n’a pas d’en-tête&#xa0;: le sens de ses colonnes est jugé d’après leurs valeurs</translation>
    </message>
    <message>
        <source>say what they are: --columns time=1:s,x=2:mm,y=3:mm,z=4:mm</source>
        <translation>l’indiquer&#xa0;: --columns time=1:s,x=2:mm,y=3:mm,z=4:mm</translation>
    </message>
    <message>
        <source>the trace has no times: one sample each millisecond is assumed</source>
        <translation>la trace n’a pas de temps&#xa0;: un échantillon par milliseconde est supposé</translation>
    </message>
    <message>
        <source>if it was recorded at another rate, say it in samples a second, as --columns linuxcnc,rate=1000</source>
        <translation>si elle a été enregistrée à une autre cadence, indiquez-la en échantillons par seconde, comme --columns linuxcnc,rate=1000</translation>
    </message>
    <message>
        <source>traces of this kind have times of their own: the rate is not used</source>
        <translation>les traces de ce type ont leurs propres temps&#xa0;: la cadence n’est pas utilisée</translation>
    </message>
    <message>
        <source>leave out rate= and period=</source>
        <translation>omettez rate= et period=</translation>
    </message>
    <message>
        <source>times of the trace</source>
        <translation>temps de la trace</translation>
    </message>
    <message>
        <source>rate as given</source>
        <translation>cadence donnée</translation>
    </message>
    <message>
        <source>servo period of the machine</source>
        <translation>période d’asservissement de la machine</translation>
    </message>
    <message>
        <source>assumed rate</source>
        <translation>cadence supposée</translation>
    </message>
    <message>
        <source>say the rate in samples a second, as --columns linuxcnc,rate=1000; or give the machine its servo period</source>
        <translation>indiquez la cadence en échantillons par seconde, comme --columns linuxcnc,rate=1000&#xa0;; ou donnez à la machine sa période d’asservissement</translation>
    </message>
    <message>
        <source>the records before it are used</source>
        <translation>les enregistrements précédents sont utilisés</translation>
    </message>
    <message>
        <source>the program lines of the trace are not those of this program; it is matched by position alone</source>
        <translation>les lignes de programme de la trace ne sont pas celles de ce programme&#xa0;; elle est posée d’après la position seule</translation>
    </message>
    <message>
        <source>record the line of the file, or number its blocks</source>
        <translation>enregistrer la ligne du fichier, ou numéroter ses blocs</translation>
    </message>
    <message>
        <source>This model holds no acceleration and jerk limits of the axes: largest values may be above what the machine allows.</source>
        <translation>Ce modèle ne respecte aucune limite d’accélération et de jerk des axes : les valeurs maximales peuvent dépasser ce que la machine permet.</translation>
    </message>
    <message>
        <source>Velocity, acceleration and jerk of X, Y and Z are those of the tool&apos;s tip in the part; where rotary axes turn, the axes of the machine move otherwise.</source>
        <translation>Vitesse, accélération et jerk de X, Y et Z sont ceux de la pointe de l’outil dans la pièce ; là où des axes rotatifs tournent, les axes de la machine se déplacent autrement.</translation>
    </message>
    <message>
        <source>Tool length</source>
        <translation>Longueur d’outil</translation>
    </message>
    <message>
        <source>From the gauge point of the spindle to the tip of the tool; it says how X, Y and Z follow rotary axes. Without it the one of the machine&apos;s kinematics.</source>
        <translation>Du point de référence de la broche à la pointe de l’outil ; elle détermine comment X, Y et Z suivent les axes rotatifs. En son absence, celle de la cinématique de la machine.</translation>
    </message>
    <message>
        <source>Orientation tolerance</source>
        <translation>Tolérance d’orientation</translation>
    </message>
    <message>
        <source>How far rotary axes may leave their programmed angles where blocks meet along which they turn at different rates; without it 0.05 degrees.</source>
        <translation>Écart admis des axes rotatifs à leurs angles programmés là où se joignent des blocs le long desquels ils tournent à des vitesses différentes ; en son absence, 0,05 degré.</translation>
    </message>
    <message>
        <source>How the part is turned in the clamping, about X, then Y, then Z, against how the program was made for; rotary axes stand as if the program had been posted again.</source>
        <translation>Rotation de la pièce dans son bridage, autour de X, puis de Y, puis de Z, par rapport à celle pour laquelle le programme a été fait ; les axes rotatifs prennent les angles que donnerait un nouveau post-traitement.</translation>
    </message>
    <message>
        <source>Velocity of %1 of the machine</source>
        <translation>Vitesse de %1 de la machine</translation>
    </message>
    <message>
        <source>%1 of the machine</source>
        <translation>%1 de la machine</translation>
    </message>
    <message>
        <source>Acceleration of %1 of the machine</source>
        <translation>Accélération de %1 de la machine</translation>
    </message>
    <message>
        <source>Jerk of %1 of the machine</source>
        <translation>Jerk de %1 de la machine</translation>
    </message>
    <message>
        <source>Position of %1 of the machine</source>
        <translation>Position de %1 de la machine</translation>
    </message>
    <message>
        <source>The program turns rotary axes, which this machine does not have: the time of their turns is missing, and they hold no feed. Choose a machine that has them, such as five-axis-table-ac.</source>
        <translation>Le programme fait tourner des axes rotatifs que cette machine n’a pas : le temps de leurs rotations manque et ils ne limitent pas l’avance. Choisissez une machine qui en a, comme five-axis-table-ac.</translation>
    </message>
    <message>
        <source>This model does not hold the limits of rotary axes in full: their largest values may be above what the machine allows.</source>
        <translation>Ce modèle ne tient pas entièrement les limites des axes rotatifs : leurs valeurs maximales peuvent dépasser ce que la machine permet.</translation>
    </message>
    <message>
        <source>uncertainties</source>
        <translation>incertitudes</translation>
    </message>
    <message>
        <source>whether another number can stand for it</source>
        <translation>si un autre nombre peut le remplacer</translation>
    </message>
    <message>
        <source>all numbers, refined</source>
        <translation>tous les nombres, affinés</translation>
    </message>
    <message>
        <source>all numbers together</source>
        <translation>tous les nombres ensemble</translation>
    </message>
    <message>
        <source>each number alone</source>
        <translation>chaque nombre seul</translation>
    </message>
    <message>
        <source>what the axes reach</source>
        <translation>ce que les axes atteignent</translation>
    </message>
    <message>
        <source>Where blocks meet along which rotary axes turn, acceleration and jerk of axes may be above their limits for a short time: rounding of the angles, corners and ramps add up there. Their velocity steps by some percent at both ends of a corner blend, which is shorter than the corner; the accelerations shown do not hold these steps.</source>
        <translation>Là où se rejoignent des blocs le long desquels des axes rotatifs tournent, accélération et jerk d’axes peuvent dépasser leurs limites pendant un court instant : l’arrondi des positions angulaires, les angles de la trajectoire et les rampes s’y ajoutent. Leur vitesse fait un saut de quelques pour cent aux deux bouts d’un arrondi d’angle, plus court que l’angle ; les accélérations montrées ne contiennent pas ces sauts.</translation>
    </message>
    <message>
        <source>No trace has both the set and the actual position of the axis.</source>
        <translation>Aucune trace ne contient à la fois la consigne et la position réelle de l’axe.</translation>
    </message>
    <message>
        <source>The axis hardly moves in these traces.</source>
        <translation>L’axe bouge à peine dans ces traces.</translation>
    </message>
    <message>
        <source>Set and actual positions do not differ by more than noise: no following error tells it.</source>
        <translation>Consigne et position réelle ne diffèrent que par le bruit : aucun écart de poursuite ne le révèle.</translation>
    </message>
    <message>
        <source>A linear drive leaves more than a third of the following error unexplained: friction, elasticity, or positions that were not recorded at the same time.</source>
        <translation>Un entraînement linéaire laisse plus d’un tiers de l’écart de poursuite inexpliqué : frottement, élasticité, ou positions qui n’ont pas été enregistrées au même instant.</translation>
    </message>
    <message>
        <source>The feed-forward would be outside 0 to 1: the positions were not recorded at the same time, or the drive has more than a linear loop.</source>
        <translation>L’anticipation serait hors de 0 à 1 : les positions n’ont pas été enregistrées au même instant, ou l’entraînement a plus qu’une boucle linéaire.</translation>
    </message>
    <message>
        <source>the rest is skipped; check the infeeds of the cycles, or raise the limit with --repeat-limit</source>
        <translation>le reste est ignoré&#xa0;; vérifiez les passes des cycles, ou augmentez la limite avec --repeat-limit</translation>
    </message>
    <message>
        <source>the rest is skipped; check the loop&apos;s condition, or raise the limit with --repeat-limit</source>
        <translation>le reste est ignoré&#xa0;; vérifiez la condition de la boucle, ou augmentez la limite avec --repeat-limit</translation>
    </message>
    <message>
        <source>the program has no blocks</source>
        <translation>le programme n’a aucun bloc</translation>
    </message>
    <message>
        <source>give a file with NC blocks such as &quot;G1 X10 F500&quot;</source>
        <translation>donnez un fichier de blocs CN comme &quot;G1 X10 F500&quot;</translation>
    </message>
    <message>
        <source>no block of the program moves an axis</source>
        <translation>aucun bloc du programme ne déplace un axe</translation>
    </message>
    <message>
        <source>if the program has another dialect, give it with --dialect</source>
        <translation>si le programme est d’un autre dialecte, indiquez-le avec --dialect</translation>
    </message>
    <message>
        <source>I J K are used as positions: as offsets from the start most arcs do not fit, as positions all of them do</source>
        <translation>I J K sont lus comme des positions&#xa0;: comme décalages depuis le départ, la plupart des arcs ne tombent pas juste, comme positions tous le font</translation>
    </message>
    <message>
        <source>program G90.1 if that is right, G91.1 if not</source>
        <translation>programmez G90.1 si c’est exact, sinon G91.1</translation>
    </message>
    <message>
        <source>G15 H selects a work offset there, G56 H a tool length, VC1 is a variable and CALL a subprogram</source>
        <translation>G15 H y choisit un décalage d’origine, G56 H une longueur d’outil, VC1 est une variable et CALL un sous-programme</translation>
    </message>
    <message>
        <source>neither drawn nor timed unless the machine gives positions (home_z_mm, part_zero_z_mm, ...); the path continues where every axis is programmed again</source>
        <translation>ni dessiné ni chronométré tant que la machine ne donne pas ces positions (home_z_mm, part_zero_z_mm, ...)&#xa0;; la trajectoire reprend là où tous les axes sont de nouveau programmés</translation>
    </message>
    <message>
        <source>I, J and K</source>
        <translation>I, J et K</translation>
    </message>
    <message>
        <source>A3, B3 and C3</source>
        <translation>A3, B3 et C3</translation>
    </message>
    <message>
        <source>TX, TY and TZ</source>
        <translation>TX, TY et TZ</translation>
    </message>
    <message>
        <source>correct the number</source>
        <translation>corrigez le nombre</translation>
    </message>
    <message>
        <source>write a smaller number</source>
        <translation>programmez un nombre plus petit</translation>
    </message>
    <message>
        <source>check the values that go into it</source>
        <translation>vérifiez les valeurs qui y entrent</translation>
    </message>
    <message>
        <source>check the brackets of the expression</source>
        <translation>vérifiez les crochets ou parenthèses de l’expression</translation>
    </message>
    <message>
        <source>split it into several assignments</source>
        <translation>répartissez-la sur plusieurs affectations</translation>
    </message>
    <message>
        <source>a value is missing at the end of the expression</source>
        <translation>il manque une valeur à la fin de l’expression</translation>
    </message>
    <message>
        <source>write a number, a variable or a function here</source>
        <translation>programmez ici un nombre, une variable ou une fonction</translation>
    </message>
    <message>
        <source>this call is skipped; check whether the subprogram calls itself, or raise the limit with --call-depth</source>
        <translation>cet appel est ignoré&#xa0;; vérifiez si le sous-programme s’appelle lui-même, ou augmentez la limite avec --call-depth</translation>
    </message>
    <message>
        <source>the program does not define its unit; mm is used</source>
        <translation>le programme ne définit pas son unité&#xa0;; le mm est utilisé</translation>
    </message>
    <message>
        <source>give it as an import option: --unit mm or --unit inch</source>
        <translation>donnez-la en option de lecture&#xa0;: --unit mm ou --unit inch</translation>
    </message>
    <message>
        <source>it is UTF-16</source>
        <translation>il est en UTF-16</translation>
    </message>
    <message>
        <source>the rest is control characters only</source>
        <translation>le reste n’est que caractères de commande</translation>
    </message>
    <message>
        <source>the table in the program&apos;s folder is not used; correct it, or name another one</source>
        <translation>la table du dossier du programme n’est pas utilisée&#xa0;; corrigez-la, ou nommez-en une autre</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>il manque un nombre</translation>
    </message>
    <message>
        <source>]= is missing</source>
        <translation>il manque ]=</translation>
    </message>
    <message>
        <source>rounding</source>
        <translation>arrondi</translation>
    </message>
    <message>
        <source>chamfer</source>
        <translation>chanfrein</translation>
    </message>
    <message>
        <source>no line or arc follows in the same plane</source>
        <translation>aucune droite et aucun arc ne suit dans le même plan</translation>
    </message>
    <message>
        <source>the corner stays sharp</source>
        <translation>l’angle reste vif</translation>
    </message>
    <message>
        <source>the corner stays sharp; write it between two of them</source>
        <translation>l’angle reste vif&#xa0;; programmez-le entre deux de ces éléments</translation>
    </message>
    <message>
        <source>the adjacent elements leave the working plane</source>
        <translation>les éléments voisins quittent le plan de travail</translation>
    </message>
    <message>
        <source>it is adjacent to a rapid</source>
        <translation>il touche un déplacement rapide</translation>
    </message>
    <message>
        <source>the control reduces it too, by its own rule</source>
        <translation>la commande le réduit aussi, selon sa propre règle</translation>
    </message>
    <message>
        <source>the path turns back at the corner</source>
        <translation>la trajectoire fait demi-tour dans l’angle</translation>
    </message>
    <message>
        <source>it does not fit between the adjacent elements</source>
        <translation>il ne tient pas entre les éléments voisins</translation>
    </message>
    <message>
        <source>the corner stays sharp; make it smaller</source>
        <translation>l’angle reste vif&#xa0;; réduisez-le</translation>
    </message>
    <message>
        <source>it is adjacent to an arc</source>
        <translation>il touche un arc</translation>
    </message>
    <message>
        <source>the corner stays sharp; a chamfer is supported between two lines</source>
        <translation>l’angle reste vif&#xa0;; un chanfrein est possible entre deux droites</translation>
    </message>
    <message>
        <source>cutter radius compensation begins on an arc</source>
        <translation>la correction de rayon commence sur un arc</translation>
    </message>
    <message>
        <source>a straight line leads to the start of the offset arc; begin it on a line</source>
        <translation>une droite mène au départ de l’arc décalé&#xa0;; commencez-la sur une droite</translation>
    </message>
    <message>
        <source>cutter radius compensation ends on an arc</source>
        <translation>la correction de rayon se termine sur un arc</translation>
    </message>
    <message>
        <source>a straight line leads to its end instead; end it on a line</source>
        <translation>une droite mène à sa fin à la place&#xa0;; terminez-la sur une droite</translation>
    </message>
    <message>
        <source>use a smaller tool, or do not begin the contour in an inside corner</source>
        <translation>prenez un outil plus petit, ou ne commencez pas le contour dans un angle rentrant</translation>
    </message>
    <message>
        <source>the plane changes while cutter radius compensation is on</source>
        <translation>le plan change pendant la correction de rayon</translation>
    </message>
    <message>
        <source>it begins again in the other plane; end it before</source>
        <translation>elle recommence dans l’autre plan&#xa0;; terminez-la avant</translation>
    </message>
    <message>
        <source>a straight line to its end is used instead, which cuts into the contour; use a smaller tool</source>
        <translation>une droite jusqu’à sa fin est utilisée à la place et entame le contour&#xa0;; prenez un outil plus petit</translation>
    </message>
    <message>
        <source>the path shown cuts into the contour here; use a smaller tool</source>
        <translation>la trajectoire affichée entame ici le contour&#xa0;; prenez un outil plus petit</translation>
    </message>
    <message>
        <source>the control does not check this before an arc: it runs a line backwards, an arc nearly a whole turn, and cuts into the contour; use a smaller tool</source>
        <translation>la commande ne vérifie pas cela devant un arc&#xa0;: elle parcourt une ligne à rebours, un arc presque d’un tour entier, et entame le contour&#xa0;; prenez un outil plus petit</translation>
    </message>
    <message>
        <source>its limits hold along each block and where blocks meet</source>
        <translation>ses limites valent le long de chaque bloc et à la jonction des blocs</translation>
    </message>
    <message>
        <source>X, Y and Z are shown as programmed, not as the tool moves on the part; the limits of the axis hold along each block</source>
        <translation>X, Y et Z sont affichés comme programmés, non comme l’outil se déplace sur la pièce&#xa0;; les limites de l’axe valent le long de chaque bloc</translation>
    </message>
    <message>
        <source>a control whose axis takes the shortest way turns less; its time is that of the way as written</source>
        <translation>une commande dont l’axe prend le chemin le plus court tourne moins&#xa0;; son temps est celui du chemin tel qu’il est écrit</translation>
    </message>
    <message>
        <source>the direction is used; remove one of them</source>
        <translation>la direction est utilisée&#xa0;; supprimez l’un des deux</translation>
    </message>
    <message>
        <source>tool orientation</source>
        <translation>l’orientation de l’outil</translation>
    </message>
    <message>
        <source>tool vectors turn the rotary axes</source>
        <translation>des vecteurs d’outil font tourner les axes rotatifs</translation>
    </message>
    <message>
        <source>the tool goes along a great circle in each block, to the position that it leads to; rounded where blocks meet</source>
        <translation>l’outil suit un grand cercle dans chaque bloc, jusqu’à la position à laquelle il mène&#xa0;; arrondi à la jonction des blocs</translation>
    </message>
    <message>
        <source>to the nearer of two positions, the axes linearly along each block; rounded where blocks meet</source>
        <translation>vers la plus proche de deux positions, les axes linéairement le long de chaque bloc&#xa0;; arrondi à la jonction des blocs</translation>
    </message>
    <message>
        <source>X, Y and Z are those of the tool&apos;s tip and shown as programmed</source>
        <translation>X, Y et Z sont ceux de la pointe de l’outil et affichés comme programmés</translation>
    </message>
    <message>
        <source>X, Y and Z are shown as programmed</source>
        <translation>X, Y et Z sont affichés comme programmés</translation>
    </message>
    <message>
        <source>a rounding or chamfer of a non-uniformly scaled contour is not supported</source>
        <translation>un arrondi ou chanfrein d’un contour à facteurs d’échelle inégaux n’est pas pris en charge</translation>
    </message>
    <message>
        <source>the arc is scaled non-uniformly and becomes an ellipse</source>
        <translation>l’arc a des facteurs d’échelle inégaux et devient une ellipse</translation>
    </message>
    <message>
        <source>it is approximated by lines within 0.001 mm</source>
        <translation>elle est approchée par des droites à 0,001 mm près</translation>
    </message>
    <message>
        <source>the axis is assumed where it was before the move to the machine position; program it first</source>
        <translation>l’axe est supposé là où il était avant d’aller à la position machine&#xa0;; programmez-le d’abord</translation>
    </message>
    <message>
        <source>a curve is approximated by tangent arcs within 0.001 mm of it</source>
        <translation>une courbe est approchée par des arcs tangents à 0,001 mm près</translation>
    </message>
    <message>
        <source>a curve under cutter compensation or at a rounded corner is approximated by lines within 0.001 mm</source>
        <translation>une courbe sous correction de rayon ou à un angle arrondi est approchée par des droites à 0,001 mm près</translation>
    </message>
    <message>
        <source>the program has more than 65536 different path control settings</source>
        <translation>le programme a plus de 65536 réglages différents du suivi de trajectoire</translation>
    </message>
    <message>
        <source>the last one stays in force; split the program</source>
        <translation>le dernier reste en vigueur&#xa0;; divisez le programme</translation>
    </message>
    <message>
        <source>the arc&apos;s centre is its start point</source>
        <translation>le centre de l’arc est son point de départ</translation>
    </message>
    <message>
        <source>a straight line to its end is used instead</source>
        <translation>une droite jusqu’à sa fin est utilisée à la place</translation>
    </message>
    <message>
        <source>an offset (G91.1)</source>
        <translation>décalage (G91.1)</translation>
    </message>
    <message>
        <source>a position (G90.1)</source>
        <translation>position (G90.1)</translation>
    </message>
    <message>
        <source>check the centre</source>
        <translation>vérifiez le centre</translation>
    </message>
    <message>
        <source>an arc given by its radius must not end where it starts</source>
        <translation>un arc donné par son rayon ne doit pas finir là où il commence</translation>
    </message>
    <message>
        <source>write a full circle with its centre</source>
        <translation>programmez un cercle complet avec son centre</translation>
    </message>
    <message>
        <source>a feed per revolution without a spindle speed</source>
        <translation>une avance par tour sans vitesse de broche</translation>
    </message>
    <message>
        <source>a feed move without a feed</source>
        <translation>un déplacement en avance sans avance</translation>
    </message>
    <message>
        <source>it runs as fast as the axes allow; write S before it</source>
        <translation>il va aussi vite que les axes le permettent&#xa0;; programmez S avant</translation>
    </message>
    <message>
        <source>it runs as fast as the axes allow; write F before it</source>
        <translation>il va aussi vite que les axes le permettent&#xa0;; programmez F avant</translation>
    </message>
    <message>
        <source>the program has more than 65535 different spindle speeds</source>
        <translation>le programme a plus de 65535 vitesses de broche différentes</translation>
    </message>
    <message>
        <source>motions with further ones have no spindle speed and no cutting load</source>
        <translation>les déplacements aux vitesses suivantes n’ont ni vitesse de broche ni effort de coupe</translation>
    </message>
    <message>
        <source>how X, Y and Z follow the rotary axes is not known without tool length and part zero</source>
        <translation>sans longueur d’outil ni origine pièce, la façon dont X, Y et Z suivent les axes rotatifs est inconnue</translation>
    </message>
    <message>
        <source>where rotary axes turn, their own limits hold and those of X, Y and Z as without them; give tool_length_mm and part_zero_x_mm, _y_mm, _z_mm</source>
        <translation>là où des axes rotatifs tournent, leurs propres limites valent, et celles de X, Y et Z comme sans eux&#xa0;; donnez tool_length_mm et part_zero_x_mm, _y_mm, _z_mm</translation>
    </message>
    <message>
        <source>two positions of the rotary axes give the tool vector and are equally near</source>
        <translation>deux positions des axes rotatifs donnent le vecteur d’outil et sont aussi proches l’une que l’autre</translation>
    </message>
    <message>
        <source>one of them is used; a control may choose the other</source>
        <translation>l’une d’elles est utilisée&#xa0;; une commande peut choisir l’autre</translation>
    </message>
    <message>
        <source>a control may stop, limit the turn or go another way; near the singular position smaller steps of the tool vector, or a part that is clamped at a tilt, make it turn less</source>
        <translation>une commande peut s’arrêter, limiter la rotation ou prendre un autre chemin&#xa0;; près de la position singulière, des pas plus petits du vecteur d’outil, ou une pièce bridée inclinée, réduisent la rotation</translation>
    </message>
    <message>
        <source>the part stays as programmed: the program sends the rotary axes of one machine to angles</source>
        <translation>la pièce reste comme programmée&#xa0;: le programme envoie les axes rotatifs d’une machine à des angles</translation>
    </message>
    <message>
        <source>part_angle_x_deg, _y_deg and _z_deg turn the part under programs with tool vectors, tilted planes or tool centre point control; post this one again</source>
        <translation>part_angle_x_deg, _y_deg et _z_deg tournent la pièce sous des programmes à vecteurs d’outil, plans inclinés ou suivi de la pointe de l’outil (RTCP)&#xa0;; repassez celui-ci au post-processeur</translation>
    </message>
    <message>
        <source>the time of the whole way is counted; a control refuses the block</source>
        <translation>le temps du chemin entier est compté&#xa0;; une commande refuse le bloc</translation>
    </message>
    <message>
        <source>the rotary axes stay; tilt less, or choose another machine</source>
        <translation>les axes rotatifs ne bougent pas&#xa0;; inclinez moins, ou choisissez une autre machine</translation>
    </message>
    <message>
        <source>a positive angle</source>
        <translation>un angle positif</translation>
    </message>
    <message>
        <source>a negative angle</source>
        <translation>un angle négatif</translation>
    </message>
    <message>
        <source>the other position is used; ask for the other side</source>
        <translation>l’autre position est utilisée&#xa0;; demandez l’autre côté</translation>
    </message>
    <message>
        <source>an approach or departure without RL or RR</source>
        <translation>une approche ou une sortie sans RL ni RR</translation>
    </message>
    <message>
        <source>the left side is assumed; write RL or RR</source>
        <translation>le côté gauche est supposé&#xa0;; programmez RL ou RR</translation>
    </message>
    <message>
        <source>its length LEN</source>
        <translation>sa longueur LEN</translation>
    </message>
    <message>
        <source>its angle CCA</source>
        <translation>son angle CCA</translation>
    </message>
    <message>
        <source>its radius R</source>
        <translation>son rayon R</translation>
    </message>
    <message>
        <source>the approach or departure is skipped</source>
        <translation>l’approche ou la sortie est ignorée</translation>
    </message>
    <message>
        <source>the preceding block is not a line to the first point of the contour</source>
        <translation>le bloc précédent n’est pas une droite vers le premier point du contour</translation>
    </message>
    <message>
        <source>the contour is approached straight</source>
        <translation>le contour est approché en ligne droite</translation>
    </message>
    <message>
        <source>no contour follows the approach</source>
        <translation>aucun contour ne suit l’approche</translation>
    </message>
    <message>
        <source>a line to its first point is used; write a contour element after it</source>
        <translation>une droite vers son premier point est utilisée&#xa0;; programmez un élément de contour après elle</translation>
    </message>
    <message>
        <source>no contour element follows in the next block</source>
        <translation>aucun élément de contour ne suit dans le bloc suivant</translation>
    </message>
    <message>
        <source>the corner stays sharp; write the corner between two lines or arcs</source>
        <translation>l’angle reste vif&#xa0;; programmez l’angle entre deux droites ou arcs</translation>
    </message>
    <message>
        <source>another rounding or chamfer follows</source>
        <translation>un autre arrondi ou chanfrein suit</translation>
    </message>
    <message>
        <source>the first one is skipped</source>
        <translation>le premier est ignoré</translation>
    </message>
    <message>
        <source>the preceding block is not a contour element</source>
        <translation>le bloc précédent n’est pas un élément de contour</translation>
    </message>
    <message>
        <source>it is skipped; write the corner between two lines or arcs</source>
        <translation>il est ignoré&#xa0;; programmez l’angle entre deux droites ou arcs</translation>
    </message>
    <message>
        <source>the contour after the approach has no direction in the plane at its start</source>
        <translation>le contour après l’approche n’a pas de direction dans le plan à son départ</translation>
    </message>
    <message>
        <source>a line to its first point is used</source>
        <translation>une droite vers son premier point est utilisée</translation>
    </message>
    <message>
        <source>a line to the first point of the contour is used; start farther away or reduce R</source>
        <translation>une droite vers le premier point du contour est utilisée&#xa0;; partez de plus loin ou réduisez R</translation>
    </message>
    <message>
        <source>the departure does not follow a contour in the working plane</source>
        <translation>la sortie ne suit pas un contour dans le plan de travail</translation>
    </message>
    <message>
        <source>a line to its end is used</source>
        <translation>une droite vers sa fin est utilisée</translation>
    </message>
    <message>
        <source>a line to its end is used; end farther away or reduce R</source>
        <translation>une droite vers sa fin est utilisée&#xa0;; finissez plus loin ou réduisez R</translation>
    </message>
    <message>
        <source>it is ignored; correct the block</source>
        <translation>il est ignoré&#xa0;; corrigez le bloc</translation>
    </message>
    <message>
        <source>PR or PA</source>
        <translation>PR ou PA</translation>
    </message>
    <message>
        <source>the arc has no direction</source>
        <translation>l’arc n’a pas de sens</translation>
    </message>
    <message>
        <source>counter-clockwise is assumed; write DR+ or DR-</source>
        <translation>le sens antihoraire est supposé&#xa0;; programmez DR+ ou DR-</translation>
    </message>
    <message>
        <source>the arc has no radius</source>
        <translation>l’arc n’a pas de rayon</translation>
    </message>
    <message>
        <source>a straight line to its end is used instead; write R</source>
        <translation>une droite jusqu’à sa fin est utilisée à la place&#xa0;; programmez R</translation>
    </message>
    <message>
        <source>a tangent arc without a preceding motion in the working plane</source>
        <translation>un arc tangent sans déplacement précédent dans le plan de travail</translation>
    </message>
    <message>
        <source>the arc would end straight behind its start</source>
        <translation>l’arc finirait droit derrière son départ</translation>
    </message>
    <message>
        <source>the sign of the angle is used; write both with the same sign</source>
        <translation>le signe de l’angle est utilisé&#xa0;; programmez les deux avec le même signe</translation>
    </message>
    <message>
        <source>a tool direction (TX TY TZ) without M128 or FUNCTION TCPM</source>
        <translation>une direction d’outil (TX TY TZ) sans M128 ni FUNCTION TCPM</translation>
    </message>
    <message>
        <source>the rotary axes stay; switch tool centre point control on before it</source>
        <translation>les axes rotatifs ne bougent pas&#xa0;; activez avant le suivi de la pointe de l’outil (RTCP)</translation>
    </message>
    <message>
        <source>it is skipped; write LT, LN, CT, LCT or the polar forms with P before them</source>
        <translation>il est ignoré&#xa0;; programmez LT, LN, CT, LCT ou les formes polaires précédées de P</translation>
    </message>
    <message>
        <source>RND without a radius R</source>
        <translation>RND sans rayon R</translation>
    </message>
    <message>
        <source>polar coordinates without a pole</source>
        <translation>des coordonnées polaires sans pôle</translation>
    </message>
    <message>
        <source>a line to the known end is used; write the pole (CC, or I and J) before it</source>
        <translation>une droite vers la fin connue est utilisée&#xa0;; programmez le pôle (CC, ou I et J) avant</translation>
    </message>
    <message>
        <source>coordinates before the first of G0 to G16</source>
        <translation>des coordonnées avant le premier de G0 à G16</translation>
    </message>
    <message>
        <source>the block is skipped; correct it</source>
        <translation>le bloc est ignoré&#xa0;; corrigez-le</translation>
    </message>
    <message>
        <source>surface normals (LN) are not used</source>
        <translation>les normales à la surface (LN) ne sont pas utilisées</translation>
    </message>
    <message>
        <source>X, Y and Z are shown as programmed, without a compensation along them</source>
        <translation>X, Y et Z sont affichés comme programmés, sans correction le long d’elles</translation>
    </message>
    <message>
        <source>surface normals and tool directions (LN) are not supported</source>
        <translation>les normales à la surface et les directions d’outil (LN) ne sont pas prises en charge</translation>
    </message>
    <message>
        <source>the last feed stays in force</source>
        <translation>la dernière avance reste en vigueur</translation>
    </message>
    <message>
        <source>the position is shown as programmed</source>
        <translation>la position est affichée comme programmée</translation>
    </message>
    <message>
        <source>the upper corner of the blank is not above the lower one in every axis</source>
        <translation>le coin supérieur du brut n’est pas au-dessus du coin inférieur dans chaque axe</translation>
    </message>
    <message>
        <source>the control refuses such a blank; the path does not depend on it</source>
        <translation>la commande refuse un tel brut&#xa0;; la trajectoire n’en dépend pas</translation>
    </message>
    <message>
        <source>the scaling is ignored</source>
        <translation>la mise à l’échelle est ignorée</translation>
    </message>
    <message>
        <source>a datum shift replaces one that the plane was tilted about</source>
        <translation>un décalage d’origine en remplace un autour duquel le plan était incliné</translation>
    </message>
    <message>
        <source>it is applied in the untilted system; cancel the tilt before it, or shift in the tilted plane only</source>
        <translation>il s’applique dans le système non incliné&#xa0;; annulez l’inclinaison avant, ou ne décalez que dans le plan incliné</translation>
    </message>
    <message>
        <source>cycle 247</source>
        <translation>le cycle 247</translation>
    </message>
    <message>
        <source>a line of the datum table</source>
        <translation>une ligne de la table de points zéro</translation>
    </message>
    <message>
        <source>datums of the machine are assumed as zero, so parts of the path overlap</source>
        <translation>les points d’origine de la machine sont supposés nuls, des parties de la trajectoire se recouvrent donc</translation>
    </message>
    <message>
        <source>the vectors of PLANE VECTOR do not span a plane</source>
        <translation>les vecteurs de PLANE VECTOR ne définissent pas un plan</translation>
    </message>
    <message>
        <source>the plane does not change; check BX BY BZ and NX NY NZ</source>
        <translation>le plan ne change pas&#xa0;; vérifiez BX BY BZ et NX NY NZ</translation>
    </message>
    <message>
        <source>the points of PLANE POINTS are on one line</source>
        <translation>les points de PLANE POINTS sont alignés</translation>
    </message>
    <message>
        <source>the plane does not change; check P1X to P3Z</source>
        <translation>le plan ne change pas&#xa0;; vérifiez P1X à P3Z</translation>
    </message>
    <message>
        <source>the rotary axes stay where they are (STAY)</source>
        <translation>les axes rotatifs restent où ils sont (STAY)</translation>
    </message>
    <message>
        <source>they turn where the program positions them, as with L A+Q120 C+Q122</source>
        <translation>ils tournent là où le programme les positionne, comme par L A+Q120 C+Q122</translation>
    </message>
    <message>
        <source>cycle 19 tilts the plane</source>
        <translation>le cycle 19 incline le plan</translation>
    </message>
    <message>
        <source>the rotary axes turn where the program positions them, as with L A+Q120 C+Q122</source>
        <translation>les axes rotatifs tournent là où le programme les positionne, comme par L A+Q120 C+Q122</translation>
    </message>
    <message>
        <source>the plane is tilted by angles of more than one axis</source>
        <translation>le plan est incliné par des angles de plusieurs axes</translation>
    </message>
    <message>
        <source>the plane depends on the machine; they are used as spatial angles, as in PLANE SPATIAL</source>
        <translation>le plan dépend de la machine&#xa0;; ils sont lus comme des angles dans l’espace, comme dans PLANE SPATIAL</translation>
    </message>
    <message>
        <source>the transformation is ignored</source>
        <translation>la transformation est ignorée</translation>
    </message>
    <message>
        <source>its motion is skipped; copy the file into this folder</source>
        <translation>son déplacement est ignoré&#xa0;; copiez le fichier dans ce dossier</translation>
    </message>
    <message>
        <source>0 is used; X, Y and Z are shown in the tilted plane</source>
        <translation>0 est utilisé&#xa0;; X, Y et Z sont affichés dans le plan incliné</translation>
    </message>
    <message>
        <source>the tool radius Q108 is not known</source>
        <translation>le rayon d’outil Q108 n’est pas connu</translation>
    </message>
    <message>
        <source>0 is used; the control may still have another value, assign one first</source>
        <translation>0 est utilisé&#xa0;; la commande peut encore avoir une autre valeur, affectez-en une d’abord</translation>
    </message>
    <message>
        <source>a tool call</source>
        <translation>un appel d’outil</translation>
    </message>
    <message>
        <source>a block</source>
        <translation>un bloc</translation>
    </message>
    <message>
        <source>a pattern</source>
        <translation>un motif</translation>
    </message>
    <message>
        <source>the name of the label is not closed, or empty</source>
        <translation>le nom de l’étiquette n’est pas fermé, ou est vide</translation>
    </message>
    <message>
        <source>write it as &quot;NAME&quot;</source>
        <translation>écrivez-le &quot;NOM&quot;</translation>
    </message>
    <message>
        <source>write a whole number from 1 to 65535 or a name in quotes</source>
        <translation>programmez un nombre entier de 1 à 65535 ou un nom entre guillemets</translation>
    </message>
    <message>
        <source>the first one is used; a control refuses such a program</source>
        <translation>la première est utilisée&#xa0;; une commande refuse un tel programme</translation>
    </message>
    <message>
        <source>the jump or call is skipped</source>
        <translation>le saut ou l’appel est ignoré</translation>
    </message>
    <message>
        <source>the assignment is skipped; write &quot;...&quot; or QS parameters, joined by ||</source>
        <translation>l’affectation est ignorée&#xa0;; programmez &quot;...&quot; ou des paramètres QS, reliés par ||</translation>
    </message>
    <message>
        <source>it is skipped; write Q1 = 5</source>
        <translation>il est ignoré&#xa0;; programmez Q1 = 5</translation>
    </message>
    <message>
        <source>the value before it is assigned; correct the formula</source>
        <translation>la valeur qui le précède est affectée&#xa0;; corrigez la formule</translation>
    </message>
    <message>
        <source>the program stops here with an error (FN 14)</source>
        <translation>le programme s’arrête ici sur une erreur (FN 14)</translation>
    </message>
    <message>
        <source>the rest is skipped; check the values that lead here</source>
        <translation>le reste est ignoré&#xa0;; vérifiez les valeurs qui mènent ici</translation>
    </message>
    <message>
        <source>what it writes to the machine or reads from a table is not known</source>
        <translation>ce qu’il écrit vers la machine ou lit dans une table n’est pas connu</translation>
    </message>
    <message>
        <source>the block is skipped; check how the parameter is calculated</source>
        <translation>le bloc est ignoré&#xa0;; vérifiez le calcul du paramètre</translation>
    </message>
    <message>
        <source>a number is missing at the end of the block</source>
        <translation>il manque un nombre à la fin du bloc</translation>
    </message>
    <message>
        <source>the block is skipped; write a number or a Q parameter here</source>
        <translation>le bloc est ignoré&#xa0;; programmez ici un nombre ou un paramètre Q</translation>
    </message>
    <message>
        <source>texts are not converted to numbers; write the number</source>
        <translation>les textes ne sont pas convertis en nombres&#xa0;; programmez le nombre</translation>
    </message>
    <message>
        <source>its depth Q201 is above the surface; write it negative</source>
        <translation>sa profondeur Q201 est au-dessus de la surface&#xa0;; programmez-la négative</translation>
    </message>
    <message>
        <source>centring to a diameter needs the tool&apos;s point angle; write Q343=0 and the depth</source>
        <translation>le centrage à un diamètre demande l’angle de pointe de l’outil&#xa0;; programmez Q343=0 et la profondeur</translation>
    </message>
    <message>
        <source>the radius of the tool is not known; write a TOOL DEF with R before the tool call</source>
        <translation>le rayon de l’outil n’est pas connu&#xa0;; programmez un TOOL DEF avec R avant l’appel de l’outil</translation>
    </message>
    <message>
        <source>it has no pitch or the spindle no speed; write S in the tool call</source>
        <translation>il n’a pas de pas ou la broche pas de vitesse&#xa0;; programmez S dans l’appel de l’outil</translation>
    </message>
    <message>
        <source>it would take more than 10000 infeeds, or its infeeds are negative; check Q202 and the other infeeds</source>
        <translation>il prendrait plus de 10000 passes, ou ses passes sont négatives&#xa0;; vérifiez Q202 et les autres passes</translation>
    </message>
    <message>
        <source>several infeeds (Q202 below its depth) are not supported; write Q202=0 for one</source>
        <translation>plusieurs passes (Q202 inférieur à sa profondeur) ne sont pas prises en charge&#xa0;; programmez Q202=0 pour une seule</translation>
    </message>
    <message>
        <source>its depth Q249 is not above zero; write it positive</source>
        <translation>sa profondeur Q249 n’est pas supérieure à zéro&#xa0;; programmez-la positive</translation>
    </message>
    <message>
        <source>the direction Q214 in which the tool passes the hole is not 1 to 4</source>
        <translation>la direction Q214 dans laquelle l’outil passe le trou n’est pas 1 à 4</translation>
    </message>
    <message>
        <source>CYCL CALL PAT without PATTERN DEF</source>
        <translation>CYCL CALL PAT sans PATTERN DEF</translation>
    </message>
    <message>
        <source>CYCL CALL PAT of a program (cycle 12) is not supported</source>
        <translation>CYCL CALL PAT d’un programme (cycle 12) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>the calls are skipped</source>
        <translation>les appels sont ignorés</translation>
    </message>
    <message>
        <source>write parameters as Q200=2</source>
        <translation>écrivez les paramètres comme Q200=2</translation>
    </message>
    <message>
        <source>write a number, or the GLOBAL DEF before it</source>
        <translation>programmez un nombre, ou le GLOBAL DEF avant</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>programmez un nombre</translation>
    </message>
    <message>
        <source>the cycle is skipped; write all of its parameters</source>
        <translation>le cycle est ignoré&#xa0;; programmez tous ses paramètres</translation>
    </message>
    <message>
        <source>the cycle is skipped</source>
        <translation>le cycle est ignoré</translation>
    </message>
    <message>
        <source>the length of its point is in the tool table; the depth is shown as that of the tip</source>
        <translation>la longueur de sa pointe est dans la table d’outils&#xa0;; la profondeur est affichée comme celle de la pointe</translation>
    </message>
    <message>
        <source>it does not move by itself</source>
        <translation>il ne déplace rien par lui-même</translation>
    </message>
    <message>
        <source>its motion is skipped wherever it is called</source>
        <translation>son déplacement est ignoré partout où il est appelé</translation>
    </message>
    <message>
        <source>a cycle is called, but none is defined</source>
        <translation>un cycle est appelé, mais aucun n’est défini</translation>
    </message>
    <message>
        <source>the call is skipped</source>
        <translation>l’appel est ignoré</translation>
    </message>
    <message>
        <source>the pattern is skipped</source>
        <translation>le motif est ignoré</translation>
    </message>
    <message>
        <source>the pattern is skipped; define a cycle from 200 to 209 or 240 before it</source>
        <translation>le motif est ignoré&#xa0;; définissez avant un cycle de 200 à 209 ou 240</translation>
    </message>
    <message>
        <source>cycle 220: Q365=1 goes from place to place on the circle</source>
        <translation>cycle 220&#xa0;: Q365=1 va d’un emplacement à l’autre sur le cercle</translation>
    </message>
    <message>
        <source>the holes are right, the way between them is shown straight</source>
        <translation>les trous sont justes, le chemin entre eux est affiché droit</translation>
    </message>
    <message>
        <source>the pattern is skipped; check NUM, NUMX and NUMY</source>
        <translation>le motif est ignoré&#xa0;; vérifiez NUM, NUMX et NUMY</translation>
    </message>
    <message>
        <source>the pattern is skipped; write POS, ROW, PAT, FRAME, CIRC or PITCHCIRC</source>
        <translation>le motif est ignoré&#xa0;; programmez POS, ROW, PAT, FRAME, CIRC ou PITCHCIRC</translation>
    </message>
    <message>
        <source>PATTERN DEF without a pattern</source>
        <translation>PATTERN DEF sans motif</translation>
    </message>
    <message>
        <source>write POS1 (X+5 Y+5 Z+0)</source>
        <translation>programmez POS1 (X+5 Y+5 Z+0)</translation>
    </message>
    <message>
        <source>a feed per tooth without the number of teeth, which is in the tool table</source>
        <translation>une avance par dent sans le nombre de dents, qui est dans la table d’outils</translation>
    </message>
    <message>
        <source>one tooth is assumed; write F or FU</source>
        <translation>une dent est supposée&#xa0;; programmez F ou FU</translation>
    </message>
    <message>
        <source>the tolerance in force stays</source>
        <translation>la tolérance en vigueur est conservée</translation>
    </message>
    <message>
        <source>it is skipped; write R</source>
        <translation>il est ignoré&#xa0;; programmez R</translation>
    </message>
    <message>
        <source>the block is skipped; the control may run another path</source>
        <translation>le bloc est ignoré&#xa0;; la commande peut suivre une autre trajectoire</translation>
    </message>
    <message>
        <source>G without a number</source>
        <translation>G sans numéro</translation>
    </message>
    <message>
        <source>the block is skipped; write a code such as G1</source>
        <translation>le bloc est ignoré&#xa0;; programmez un code comme G1</translation>
    </message>
    <message>
        <source>the path is shown as programmed</source>
        <translation>la trajectoire est affichée comme programmée</translation>
    </message>
    <message>
        <source>the path with RL and RR is shown without it</source>
        <translation>la trajectoire avec RL et RR est affichée sans cela</translation>
    </message>
    <message>
        <source>the programmed feed is shown</source>
        <translation>l’avance programmée est affichée</translation>
    </message>
    <message>
        <source>small contour steps</source>
        <translation>petits décrochements de contour</translation>
    </message>
    <message>
        <source>open contour corners</source>
        <translation>angles de contour ouverts</translation>
    </message>
    <message>
        <source>feed factor for plunging</source>
        <translation>facteur d’avance en plongée</translation>
    </message>
    <message>
        <source>constant feed of the cutting edge</source>
        <translation>avance constante à l’arête de coupe</translation>
    </message>
    <message>
        <source>constant feed of the cutting edge on inside arcs</source>
        <translation>avance constante à l’arête de coupe dans les arcs intérieurs</translation>
    </message>
    <message>
        <source>rounding between contour elements</source>
        <translation>arrondi entre éléments de contour</translation>
    </message>
    <message>
        <source>rotary axes with tool compensation</source>
        <translation>axes rotatifs avec correction d’outil</translation>
    </message>
    <message>
        <source>filter of short lines</source>
        <translation>filtre de petits segments</translation>
    </message>
    <message>
        <source>X, Y and Z of the tool tip are shown</source>
        <translation>X, Y et Z de la pointe de l’outil sont affichés</translation>
    </message>
    <message>
        <source>positions in the untilted system</source>
        <translation>positions dans le système non incliné</translation>
    </message>
    <message>
        <source>tangential corners</source>
        <translation>angles tangents</translation>
    </message>
    <message>
        <source>M without a number</source>
        <translation>M sans numéro</translation>
    </message>
    <message>
        <source>the block is skipped; write a function such as M3</source>
        <translation>le bloc est ignoré&#xa0;; programmez une fonction comme M3</translation>
    </message>
    <message>
        <source>FUNCTION TCPM is followed as with F TCP, AXIS POS and REFPNT TIP-TIP</source>
        <translation>FUNCTION TCPM est suivie comme avec F TCP, AXIS POS et REFPNT TIP-TIP</translation>
    </message>
    <message>
        <source>F holds at the tip, and angles are those of the axes</source>
        <translation>F vaut à la pointe, et les angles sont ceux des axes</translation>
    </message>
    <message>
        <source>this form of tilted working plane</source>
        <translation>cette forme de plan de travail incliné</translation>
    </message>
    <message>
        <source>the path is shown untilted</source>
        <translation>la trajectoire est affichée sans inclinaison</translation>
    </message>
    <message>
        <source>function of the machine</source>
        <translation>fonction de la machine</translation>
    </message>
    <message>
        <source>polar kinematics</source>
        <translation>cinématique polaire</translation>
    </message>
    <message>
        <source>free contour</source>
        <translation>contour libre</translation>
    </message>
    <message>
        <source>touch probe cycle</source>
        <translation>cycle de palpage</translation>
    </message>
    <message>
        <source>another machining mode</source>
        <translation>autre mode d’usinage</translation>
    </message>
    <message>
        <source>its path is shown as in milling mode</source>
        <translation>sa trajectoire est affichée comme en mode fraisage</translation>
    </message>
    <message>
        <source>selection of a table, pattern or program</source>
        <translation>choix d’une table, d’un motif ou d’un programme</translation>
    </message>
    <message>
        <source>what it selects is not known</source>
        <translation>ce qu’il choisit n’est pas connu</translation>
    </message>
    <message>
        <source>contour definition</source>
        <translation>définition de contour</translation>
    </message>
    <message>
        <source>file access</source>
        <translation>accès à un fichier</translation>
    </message>
    <message>
        <source>it is skipped; if the program has another dialect, give it with --dialect</source>
        <translation>il est ignoré&#xa0;; si le programme est d’un autre dialecte, indiquez-le avec --dialect</translation>
    </message>
    <message>
        <source>nothing is called; write P with the number of the subprogram</source>
        <translation>rien n’est appelé&#xa0;; programmez P avec le numéro du sous-programme</translation>
    </message>
    <message>
        <source>M97 without P and the number of a block in this program</source>
        <translation>M97 sans P ni numéro d’un bloc de ce programme</translation>
    </message>
    <message>
        <source>nothing is called; write P with the N number of the first block</source>
        <translation>rien n’est appelé&#xa0;; programmez P avec le numéro N du premier bloc</translation>
    </message>
    <message>
        <source>the jump is skipped; correct the number</source>
        <translation>le saut est ignoré&#xa0;; corrigez le numéro</translation>
    </message>
    <message>
        <source>one pass is shown</source>
        <translation>un seul passage est affiché</translation>
    </message>
    <message>
        <source>it is run once</source>
        <translation>il est exécuté une fois</translation>
    </message>
    <message>
        <source>nothing is called; write P with the macro&apos;s number</source>
        <translation>rien n’est appelé&#xa0;; programmez P avec le numéro de la macro</translation>
    </message>
    <message>
        <source>the block does not move; variable numbers are whole and start at 0</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; les numéros de variable sont entiers et commencent à 0</translation>
    </message>
    <message>
        <source>&quot;&gt;&quot; is missing after the name</source>
        <translation>il manque &quot;&gt;&quot; après le nom</translation>
    </message>
    <message>
        <source>close the name with &quot;&gt;&quot;</source>
        <translation>fermez le nom par &quot;&gt;&quot;</translation>
    </message>
    <message>
        <source>the name between &quot;&lt;&quot; and &quot;&gt;&quot; is empty</source>
        <translation>le nom entre &quot;&lt;&quot; et &quot;&gt;&quot; est vide</translation>
    </message>
    <message>
        <source>write a name</source>
        <translation>programmez un nom</translation>
    </message>
    <message>
        <source>EXISTS needs a named variable</source>
        <translation>EXISTS demande une variable nommée</translation>
    </message>
    <message>
        <source>write EXISTS[#&lt;name&gt;]</source>
        <translation>programmez EXISTS[#&lt;nom&gt;]</translation>
    </message>
    <message>
        <source>the block does not move; correct the word or write a plain number</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; corrigez le mot ou programmez un simple nombre</translation>
    </message>
    <message>
        <source>the rest of the line is used as the comment; add the closing bracket</source>
        <translation>le reste de la ligne est pris comme commentaire&#xa0;; ajoutez la parenthèse fermante</translation>
    </message>
    <message>
        <source>the rest of the line is skipped and the block does not move; remove the character</source>
        <translation>le reste de la ligne est ignoré et le bloc n’a pas de déplacement&#xa0;; supprimez le caractère</translation>
    </message>
    <message>
        <source>loop around it</source>
        <translation>boucle qui l’entoure</translation>
    </message>
    <message>
        <source>END with its number</source>
        <translation>END à son numéro</translation>
    </message>
    <message>
        <source>DO with its number</source>
        <translation>DO à son numéro</translation>
    </message>
    <message>
        <source>it is skipped; check the labels</source>
        <translation>il est ignoré&#xa0;; vérifiez les étiquettes</translation>
    </message>
    <message>
        <source>it is skipped; write it in a line of its own</source>
        <translation>il est ignoré&#xa0;; programmez-le sur une ligne à part</translation>
    </message>
    <message>
        <source>the line is skipped; O words are sub, call, if, while, do, repeat and their ends</source>
        <translation>la ligne est ignorée&#xa0;; les mots O sont sub, call, if, while, do, repeat et leurs fins</translation>
    </message>
    <message>
        <source>a call has more than 30 arguments</source>
        <translation>un appel a plus de 30 arguments</translation>
    </message>
    <message>
        <source>the call is skipped; pass the rest in global variables</source>
        <translation>l’appel est ignoré&#xa0;; passez le reste dans des variables globales</translation>
    </message>
    <message>
        <source>return or endsub outside a subprogram</source>
        <translation>return ou endsub hors d’un sous-programme</translation>
    </message>
    <message>
        <source>it is skipped; a subprogram is written between sub and endsub</source>
        <translation>il est ignoré&#xa0;; un sous-programme s’écrit entre sub et endsub</translation>
    </message>
    <message>
        <source>LinuxCNC rejects the program; write one subprogram after the other</source>
        <translation>LinuxCNC refuse le programme&#xa0;; écrivez les sous-programmes l’un après l’autre</translation>
    </message>
    <message>
        <source>it does not change the path</source>
        <translation>cela ne change pas la trajectoire</translation>
    </message>
    <message>
        <source>GOTO or THEN is missing after the condition</source>
        <translation>il manque GOTO ou THEN après la condition</translation>
    </message>
    <message>
        <source>the line is skipped; complete it</source>
        <translation>la ligne est ignorée&#xa0;; complétez-la</translation>
    </message>
    <message>
        <source>the block does not move; if the program has another dialect, give it with --dialect</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; si le programme est d’un autre dialecte, indiquez-le avec --dialect</translation>
    </message>
    <message>
        <source>the block does not move; check the values that go into it</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; vérifiez les valeurs qui y entrent</translation>
    </message>
    <message>
        <source>&quot;=&quot; is missing after the variable</source>
        <translation>il manque &quot;=&quot; après la variable</translation>
    </message>
    <message>
        <source>write its value</source>
        <translation>programmez sa valeur</translation>
    </message>
    <message>
        <source>the assignment is skipped; use another variable</source>
        <translation>l’affectation est ignorée&#xa0;; prenez une autre variable</translation>
    </message>
    <message>
        <source>0 is used; the control may run another path</source>
        <translation>0 est utilisé&#xa0;; la commande peut suivre une autre trajectoire</translation>
    </message>
    <message>
        <source>0 is used; on the control it keeps its last value</source>
        <translation>0 est utilisé&#xa0;; sur la commande, elle garde sa dernière valeur</translation>
    </message>
    <message>
        <source>the block does not move; set it before, or check how the name is written</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; définissez-la avant, ou vérifiez l’orthographe du nom</translation>
    </message>
    <message>
        <source>the control stops here; check the condition that leads to it</source>
        <translation>la commande s’arrête ici&#xa0;; vérifiez la condition qui y mène</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; write D with the tool&apos;s diameter</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; programmez D avec le diamètre de l’outil</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; write T and M6 before it, or D</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; programmez T et M6 avant, ou D</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; write D with the tool&apos;s offset</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; programmez D avec le correcteur de l’outil</translation>
    </message>
    <message>
        <source>the radius is ignored; write P with the tool&apos;s number</source>
        <translation>le rayon est ignoré&#xa0;; programmez P avec le numéro de l’outil</translation>
    </message>
    <message>
        <source>the block has no effect on the path</source>
        <translation>le bloc n’a pas d’effet sur la trajectoire</translation>
    </message>
    <message>
        <source>the path is shown without it</source>
        <translation>la trajectoire est affichée sans cela</translation>
    </message>
    <message>
        <source>the path is shown without it; write R with the angle</source>
        <translation>la trajectoire est affichée sans cela&#xa0;; programmez R avec l’angle</translation>
    </message>
    <message>
        <source>the path is shown without it; write P with the factor</source>
        <translation>la trajectoire est affichée sans cela&#xa0;; programmez P avec le facteur</translation>
    </message>
    <message>
        <source>G68 with I0 J0 K0 has no rotation axis</source>
        <translation>G68 avec I0 J0 K0 n’a pas d’axe de rotation</translation>
    </message>
    <message>
        <source>the working plane is tilted</source>
        <translation>le plan de travail est incliné</translation>
    </message>
    <message>
        <source>the path is shown on the workpiece; on a machine that rotates the workpiece the axes move differently</source>
        <translation>la trajectoire est affichée sur la pièce&#xa0;; sur une machine qui tourne la pièce, les axes se déplacent autrement</translation>
    </message>
    <message>
        <source>G50 with S belongs to a turning program</source>
        <translation>G50 avec S appartient à un programme de tournage</translation>
    </message>
    <message>
        <source>turning is not supported: X is used as a radius, G98 and G99 as those of drilling cycles</source>
        <translation>le tournage n’est pas pris en charge&#xa0;: X est lu comme un rayon, G98 et G99 comme ceux des cycles de perçage</translation>
    </message>
    <message>
        <source>G92 gives coordinates to a position that is not known</source>
        <translation>G92 donne des coordonnées à une position qui n’est pas connue</translation>
    </message>
    <message>
        <source>the path continues where the axis was before the move to the machine position</source>
        <translation>la trajectoire continue là où l’axe était avant le déplacement vers la position machine</translation>
    </message>
    <message>
        <source>1 is used; write a factor other than zero</source>
        <translation>1 est utilisé&#xa0;; programmez un facteur non nul</translation>
    </message>
    <message>
        <source>G29 (bed levelling of printers) is not supported</source>
        <translation>G29 (nivellement du plateau d’imprimante) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>nothing moves</source>
        <translation>rien ne se déplace</translation>
    </message>
    <message>
        <source>many controls use it in units of 0.0001 inch; write a decimal point</source>
        <translation>beaucoup de commandes le lisent en unités de 0,0001 pouce&#xa0;; écrivez un point décimal</translation>
    </message>
    <message>
        <source>many controls use it in units of 0.001 mm; write a decimal point</source>
        <translation>beaucoup de commandes le lisent en unités de 0,001 mm&#xa0;; écrivez un point décimal</translation>
    </message>
    <message>
        <source>X and Y are ignored; write either of them</source>
        <translation>X et Y sont ignorés&#xa0;; programmez l’un ou l’autre</translation>
    </message>
    <message>
        <source>the tool is at X0 Y0, where it has no angle</source>
        <translation>l’outil est en X0 Y0, où il n’a pas d’angle</translation>
    </message>
    <message>
        <source>angle zero is used; write both @ and ^ with G90</source>
        <translation>l’angle nul est utilisé&#xa0;; programmez @ et ^ avec G90</translation>
    </message>
    <message>
        <source>G76 (threading cycle) is not supported</source>
        <translation>G76 (cycle de filetage) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>positions are skipped up to the next G0 to G3</source>
        <translation>les positions sont ignorées jusqu’au prochain G0 à G3</translation>
    </message>
    <message>
        <source>the tool returns to R after each hole; program the height before the cycle</source>
        <translation>l’outil revient à R après chaque trou&#xa0;; programmez la hauteur avant le cycle</translation>
    </message>
    <message>
        <source>the hole is skipped; program it in the cycle&apos;s first block</source>
        <translation>le trou est ignoré&#xa0;; programmez-le dans le premier bloc du cycle</translation>
    </message>
    <message>
        <source>the level before the cycle is used; program it in the cycle&apos;s first block</source>
        <translation>le niveau d’avant le cycle est utilisé&#xa0;; programmez-le dans le premier bloc du cycle</translation>
    </message>
    <message>
        <source>the hole is skipped; correct one of them</source>
        <translation>le trou est ignoré&#xa0;; corrigez l’un des deux</translation>
    </message>
    <message>
        <source>the positive direction of the plane&apos;s first axis is used</source>
        <translation>la direction positive du premier axe du plan est utilisée</translation>
    </message>
    <message>
        <source>the cycle runs once</source>
        <translation>le cycle est exécuté une fois</translation>
    </message>
    <message>
        <source>the hole is drilled in one infeed; write Q with the depth of a peck</source>
        <translation>le trou est percé en une passe&#xa0;; programmez Q avec la profondeur d’une passe</translation>
    </message>
    <message>
        <source>nothing is drilled; for the units inch and mm program G20 or G21</source>
        <translation>rien n’est percé&#xa0;; pour les unités pouce et mm, programmez G20 ou G21</translation>
    </message>
    <message>
        <source>the dwell is skipped</source>
        <translation>la temporisation est ignorée</translation>
    </message>
    <message>
        <source>many controls use it in units of 0.001 s; write a decimal point</source>
        <translation>beaucoup de commandes le lisent en unités de 0,001 s&#xa0;; programmez un point décimal</translation>
    </message>
    <message>
        <source>G4 without a time</source>
        <translation>G4 sans durée</translation>
    </message>
    <message>
        <source>the dwell is skipped; write P, X or U with the time</source>
        <translation>la temporisation est ignorée&#xa0;; programmez P, X ou U avec la durée</translation>
    </message>
    <message>
        <source>M72 has no modal state to restore</source>
        <translation>M72 n’a pas d’état modal à rétablir</translation>
    </message>
    <message>
        <source>nothing changes; write M70 before it</source>
        <translation>rien ne change&#xa0;; programmez M70 avant</translation>
    </message>
    <message>
        <source>it is ignored; the control may run another path</source>
        <translation>il est ignoré&#xa0;; la commande peut suivre une autre trajectoire</translation>
    </message>
    <message>
        <source>it is skipped; write it in a block of its own</source>
        <translation>il est ignoré&#xa0;; programmez-le dans un bloc à part</translation>
    </message>
    <message>
        <source>M428 is read as in LinuxCNC&apos;s own five-axis configurations: X, Y and Z are the tool&apos;s tip</source>
        <translation>M428 est lu comme dans les configurations à cinq axes de LinuxCNC&#xa0;: X, Y et Z sont la pointe de l’outil</translation>
    </message>
    <message>
        <source>a configuration may remap it otherwise</source>
        <translation>une configuration peut le redéfinir autrement</translation>
    </message>
    <message>
        <source>the last valid feed stays in force; write a feed above zero</source>
        <translation>la dernière avance valable reste en vigueur&#xa0;; programmez une avance supérieure à zéro</translation>
    </message>
    <message>
        <source>feed moves run as fast as the axes allow; write a feed above zero</source>
        <translation>les déplacements en avance vont aussi vite que les axes le permettent&#xa0;; programmez une avance supérieure à zéro</translation>
    </message>
    <message>
        <source>SET_VELOCITY_LIMIT is a command of Klipper</source>
        <translation>SET_VELOCITY_LIMIT est une commande de Klipper</translation>
    </message>
    <message>
        <source>only the model klipper follows it</source>
        <translation>seul le modèle klipper la suit</translation>
    </message>
    <message>
        <source>what it moves is not known and missing</source>
        <translation>ce qu’elle déplace n’est pas connu et manque</translation>
    </message>
    <message>
        <source>E (extruder) is not supported</source>
        <translation>E (extrudeuse) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>a move of the extruder alone (E) takes time</source>
        <translation>un déplacement de l’extrudeur seul (E) prend du temps</translation>
    </message>
    <message>
        <source>only the model klipper counts it</source>
        <translation>seul le modèle klipper le compte</translation>
    </message>
    <message>
        <source>it is skipped</source>
        <translation>il est ignoré</translation>
    </message>
    <message>
        <source>it is ignored; check whether G2 or G3 is missing</source>
        <translation>il est ignoré&#xa0;; vérifiez s’il manque G2 ou G3</translation>
    </message>
    <message>
        <source>position words before the first G0, G1, G2 or G3</source>
        <translation>des mots de position avant le premier G0, G1, G2 ou G3</translation>
    </message>
    <message>
        <source>position words after G80 without a new G0, G1, G2 or G3</source>
        <translation>des mots de position après G80 sans nouveau G0, G1, G2 ou G3</translation>
    </message>
    <message>
        <source>G0 is used; write the G word</source>
        <translation>G0 est utilisé&#xa0;; programmez le mot G</translation>
    </message>
    <message>
        <source>a feed move without F under G93</source>
        <translation>un déplacement en avance sans F sous G93</translation>
    </message>
    <message>
        <source>the last F is used; write F in every such block</source>
        <translation>le dernier F est utilisé&#xa0;; programmez F dans chacun de ces blocs</translation>
    </message>
    <message>
        <source>the corner stays sharp; write it in the G1, G2 or G3 block that ends at the corner</source>
        <translation>l’angle reste vif&#xa0;; programmez-le dans le bloc G1, G2 ou G3 qui finit dans l’angle</translation>
    </message>
    <message>
        <source>the arc has neither a centre (I, J, K) nor a radius (R)</source>
        <translation>l’arc n’a ni centre (I, J, K) ni rayon (R)</translation>
    </message>
    <message>
        <source>the arc has both a centre (I, J, K) and a radius (R)</source>
        <translation>l’arc a un centre (I, J, K) et un rayon (R)</translation>
    </message>
    <message>
        <source>R is used; remove one of them</source>
        <translation>R est utilisé&#xa0;; supprimez l’un des deux</translation>
    </message>
    <message>
        <source>one turn is used</source>
        <translation>un tour est utilisé</translation>
    </message>
    <message>
        <source>it is ignored; check whether G17, G18 or G19 is missing</source>
        <translation>il est ignoré&#xa0;; vérifiez s’il manque G17, G18 ou G19</translation>
    </message>
    <message>
        <source>its parameters exist only in the control; set acceleration and jerk of the machine instead</source>
        <translation>ses paramètres n’existent que dans la commande&#xa0;; réglez plutôt l’accélération et le jerk de la machine</translation>
    </message>
    <message>
        <source>it is ignored; write a tolerance of zero or more</source>
        <translation>elle est ignorée&#xa0;; programmez une tolérance nulle ou positive</translation>
    </message>
    <message>
        <source>G5.3 without G5.2</source>
        <translation>G5.3 sans G5.2</translation>
    </message>
    <message>
        <source>G6.2 as LinuxCNC has it (weights P, no knots K) is not supported</source>
        <translation>G6.2 à la façon de LinuxCNC (poids P, pas de nœuds K) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>positions are skipped up to the next G0 to G3; write G5.2 and G5.3</source>
        <translation>les positions sont ignorées jusqu’au prochain G0 à G3&#xa0;; programmez G5.2 et G5.3</translation>
    </message>
    <message>
        <source>a control point of G5.2 without a weight above zero</source>
        <translation>un point de contrôle de G5.2 sans poids supérieur à zéro</translation>
    </message>
    <message>
        <source>1 is used; write P with the weight</source>
        <translation>1 est utilisé&#xa0;; programmez P avec le poids</translation>
    </message>
    <message>
        <source>4 is taken</source>
        <translation>4 est utilisé</translation>
    </message>
    <message>
        <source>a control point of G6.2 without a weight above zero</source>
        <translation>un point de contrôle de G6.2 sans poids supérieur à zéro</translation>
    </message>
    <message>
        <source>1 is used; write R with the weight</source>
        <translation>1 est utilisé&#xa0;; programmez R avec le poids</translation>
    </message>
    <message>
        <source>a straight line to the last point is used instead; write as many non-decreasing K as points and order together</source>
        <translation>une droite jusqu’au dernier point est utilisée à la place&#xa0;; programmez autant de K non décroissants que la somme des points et de l’ordre</translation>
    </message>
    <message>
        <source>a straight line to the last one is used instead</source>
        <translation>une droite jusqu’au dernier est utilisée à la place</translation>
    </message>
    <message>
        <source>the curve ends at its last control point</source>
        <translation>la courbe finit à son dernier point de contrôle</translation>
    </message>
    <message>
        <source>its motion is skipped</source>
        <translation>son déplacement est ignoré</translation>
    </message>
    <message>
        <source>the path shown is that of the tool tip</source>
        <translation>la trajectoire affichée est celle de la pointe de l’outil</translation>
    </message>
    <message>
        <source>it does not change the programmed path</source>
        <translation>cela ne change pas la trajectoire programmée</translation>
    </message>
    <message>
        <source>diameter programming or cylindrical interpolation</source>
        <translation>programmation au diamètre ou interpolation cylindrique</translation>
    </message>
    <message>
        <source>cylindrical interpolation</source>
        <translation>interpolation cylindrique</translation>
    </message>
    <message>
        <source>circular pocket</source>
        <translation>poche circulaire</translation>
    </message>
    <message>
        <source>polar coordinate interpolation</source>
        <translation>interpolation en coordonnées polaires</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>courbe spline</translation>
    </message>
    <message>
        <source>probing</source>
        <translation>palpage</translation>
    </message>
    <message>
        <source>reference point check</source>
        <translation>contrôle du point de référence</translation>
    </message>
    <message>
        <source>skip motion</source>
        <translation>déplacement à interruption</translation>
    </message>
    <message>
        <source>thread cutting</source>
        <translation>filetage</translation>
    </message>
    <message>
        <source>rigid tapping</source>
        <translation>taraudage rigide</translation>
    </message>
    <message>
        <source>tool length compensation</source>
        <translation>compensation de longueur d’outil</translation>
    </message>
    <message>
        <source>tool centre point control</source>
        <translation>suivi de la pointe de l’outil (RTCP)</translation>
    </message>
    <message>
        <source>only X, Y and Z are shown</source>
        <translation>seuls X, Y et Z sont affichés</translation>
    </message>
    <message>
        <source>tool offset of one block</source>
        <translation>correcteur d’outil pour un bloc</translation>
    </message>
    <message>
        <source>engraving, or double tool offset of one block</source>
        <translation>gravure, ou correcteur d’outil double pour un bloc</translation>
    </message>
    <message>
        <source>turning of the tool axis</source>
        <translation>rotation de l’axe de l’outil</translation>
    </message>
    <message>
        <source>macro call</source>
        <translation>appel de macro</translation>
    </message>
    <message>
        <source>modal macro call</source>
        <translation>appel modal de macro</translation>
    </message>
    <message>
        <source>macro call in each block</source>
        <translation>appel de macro à chaque bloc</translation>
    </message>
    <message>
        <source>tilted working plane</source>
        <translation>plan de travail incliné</translation>
    </message>
    <message>
        <source>back boring</source>
        <translation>alésage en tirant</translation>
    </message>
    <message>
        <source>constant cutting speed</source>
        <translation>vitesse de coupe constante</translation>
    </message>
    <message>
        <source>cylindrical mapping</source>
        <translation>projection sur un cylindre</translation>
    </message>
    <message>
        <source>cutter compensation in space</source>
        <translation>correction de rayon dans l’espace</translation>
    </message>
    <message>
        <source>tool length compensation of five axes</source>
        <translation>compensation de longueur d’outil à cinq axes</translation>
    </message>
    <message>
        <source>pocket milling</source>
        <translation>fraisage de poche</translation>
    </message>
    <message>
        <source>dynamic work offset</source>
        <translation>décalage d’origine dynamique</translation>
    </message>
    <message>
        <source>write its number with digits only, as in L12; nothing is called</source>
        <translation>écrivez son numéro en chiffres seuls, comme L12&#xa0;; rien n’est appelé</translation>
    </message>
    <message>
        <source>use an R parameter or a variable defined by DEF INT</source>
        <translation>prenez un paramètre R ou une variable définie par DEF INT</translation>
    </message>
    <message>
        <source>write REAL, INT, BOOL, CHAR, STRING, AXIS or FRAME; the variables are not defined</source>
        <translation>programmez REAL, INT, BOOL, CHAR, STRING, AXIS ou FRAME&#xa0;; les variables ne sont pas définies</translation>
    </message>
    <message>
        <source>DEF without a name</source>
        <translation>DEF sans nom</translation>
    </message>
    <message>
        <source>write the variable&apos;s name after its type</source>
        <translation>écrivez le nom de la variable après son type</translation>
    </message>
    <message>
        <source>DEFINE needs a name, AS and words</source>
        <translation>DEFINE demande un nom, AS et des mots</translation>
    </message>
    <message>
        <source>its name is called as a subprogram; write DEFINE NAME AS G0 X5</source>
        <translation>son nom est appelé comme un sous-programme&#xa0;; programmez DEFINE NOM AS G0 X5</translation>
    </message>
    <message>
        <source>write the parameters in brackets, then attributes such as SAVE</source>
        <translation>écrivez les paramètres entre parenthèses, puis des attributs comme SAVE</translation>
    </message>
    <message>
        <source>write a type and a name</source>
        <translation>écrivez un type et un nom</translation>
    </message>
    <message>
        <source>0 is used; call the program with a value</source>
        <translation>0 est utilisé&#xa0;; appelez le programme avec une valeur</translation>
    </message>
    <message>
        <source>pass an array of the same type and size</source>
        <translation>passez un tableau de même type et de même taille</translation>
    </message>
    <message>
        <source>the frame does not change; write CTRANS, CROT, CSCALE, CMIRROR with axes and values, joined by &quot;:&quot;, or a variable that holds a frame</source>
        <translation>le frame ne change pas&#xa0;; programmez CTRANS, CROT, CSCALE, CMIRROR avec axes et valeurs, reliés par &quot;:&quot;, ou une variable qui contient un frame</translation>
    </message>
    <message>
        <source>a scale factor is zero</source>
        <translation>un facteur d’échelle est nul</translation>
    </message>
    <message>
        <source>parts of a chain of frames cannot be set</source>
        <translation>les parties d’une chaîne de frames ne peuvent pas être réglées</translation>
    </message>
    <message>
        <source>in $P_PFRAME only shifts of X, Y and Z (TR, FI) can be set individually</source>
        <translation>dans $P_PFRAME, seuls les décalages de X, Y et Z (TR, FI) se règlent séparément</translation>
    </message>
    <message>
        <source>an axis is missing here</source>
        <translation>il manque ici un axe</translation>
    </message>
    <message>
        <source>&quot;,&quot; or &quot;)&quot; is missing here</source>
        <translation>il manque ici &quot;,&quot; ou &quot;)&quot;</translation>
    </message>
    <message>
        <source>DEF FRAME of an array, or without a name, is not supported</source>
        <translation>DEF FRAME d’un tableau, ou sans nom, n’est pas pris en charge</translation>
    </message>
    <message>
        <source>define frames one by one</source>
        <translation>définissez les frames un par un</translation>
    </message>
    <message>
        <source>0 is used; the control has a value of its own</source>
        <translation>0 est utilisé&#xa0;; la commande a sa propre valeur</translation>
    </message>
    <message>
        <source>write &apos;H1F&apos; or &apos;B101&apos;</source>
        <translation>programmez &apos;H1F&apos; ou &apos;B101&apos;</translation>
    </message>
    <message>
        <source>compare texts with == or &lt;&gt;</source>
        <translation>comparez les textes par == ou &lt;&gt;</translation>
    </message>
    <message>
        <source>the block does not move; correct the expression</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; corrigez l’expression</translation>
    </message>
    <message>
        <source>the text is nested more than 100 deep</source>
        <translation>le texte est imbriqué sur plus de 100 niveaux</translation>
    </message>
    <message>
        <source>remove brackets</source>
        <translation>supprimez des parenthèses</translation>
    </message>
    <message>
        <source>the text is not closed</source>
        <translation>le texte n’est pas fermé</translation>
    </message>
    <message>
        <source>add the closing quotation mark</source>
        <translation>ajoutez le guillemet fermant</translation>
    </message>
    <message>
        <source>correct the size</source>
        <translation>corrigez la taille</translation>
    </message>
    <message>
        <source>correct the index or the size in DEF</source>
        <translation>corrigez l’indice ou la taille dans DEF</translation>
    </message>
    <message>
        <source>the path does not change</source>
        <translation>la trajectoire ne change pas</translation>
    </message>
    <message>
        <source>a synchronized action is not supported</source>
        <translation>une action synchrone n’est pas prise en charge</translation>
    </message>
    <message>
        <source>its value is ignored; define a variable by DEF before it is used</source>
        <translation>sa valeur est ignorée&#xa0;; définissez une variable par DEF avant de l’utiliser</translation>
    </message>
    <message>
        <source>the rest of the line is skipped and the block does not move; correct it</source>
        <translation>le reste de la ligne est ignoré et le bloc n’a pas de déplacement&#xa0;; corrigez-le</translation>
    </message>
    <message>
        <source>correct the statement; the block does not move</source>
        <translation>corrigez l’instruction&#xa0;; le bloc n’a pas de déplacement</translation>
    </message>
    <message>
        <source>the bracket is not closed</source>
        <translation>la parenthèse n’est pas fermée</translation>
    </message>
    <message>
        <source>the block does not move; correct the number</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; corrigez le nombre</translation>
    </message>
    <message>
        <source>RET with a jump target is not supported</source>
        <translation>RET avec une cible de saut n’est pas pris en charge</translation>
    </message>
    <message>
        <source>the program continues after the call; return without a target</source>
        <translation>le programme continue après l’appel&#xa0;; revenez sans cible</translation>
    </message>
    <message>
        <source>ISOCALL (call of a program in ISO dialect) is not supported</source>
        <translation>ISOCALL (appel d’un programme en dialecte ISO) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>write the name of a subprogram</source>
        <translation>écrivez le nom d’un sous-programme</translation>
    </message>
    <message>
        <source>its motion is skipped; add it to the program or to its folder</source>
        <translation>son déplacement est ignoré&#xa0;; ajoutez-le au programme ou à son dossier</translation>
    </message>
    <message>
        <source>the line is skipped; check IF, ELSE, ENDIF and the starts and ends of loops</source>
        <translation>la ligne est ignorée&#xa0;; vérifiez IF, ELSE, ENDIF et les débuts et fins de boucle</translation>
    </message>
    <message>
        <source>write GOTOF, GOTOB or GOTO with a label, or nothing, after the condition</source>
        <translation>programmez GOTOF, GOTOB ou GOTO avec une étiquette, ou rien, après la condition</translation>
    </message>
    <message>
        <source>FOR without TO</source>
        <translation>FOR sans TO</translation>
    </message>
    <message>
        <source>write FOR I=1 TO 10</source>
        <translation>programmez FOR I=1 TO 10</translation>
    </message>
    <message>
        <source>the jump is skipped; check the label and the direction of the jump</source>
        <translation>le saut est ignoré&#xa0;; vérifiez l’étiquette et le sens du saut</translation>
    </message>
    <message>
        <source>a jump without a label</source>
        <translation>un saut sans étiquette</translation>
    </message>
    <message>
        <source>write the label after GOTOF or GOTOB</source>
        <translation>écrivez l’étiquette après GOTOF ou GOTOB</translation>
    </message>
    <message>
        <source>CASE without OF</source>
        <translation>CASE sans OF</translation>
    </message>
    <message>
        <source>write CASE (R1) OF 1 GOTOF LABEL</source>
        <translation>programmez CASE (R1) OF 1 GOTOF ETIQUETTE</translation>
    </message>
    <message>
        <source>CASE without GOTOF or GOTOB</source>
        <translation>CASE sans GOTOF ni GOTOB</translation>
    </message>
    <message>
        <source>the part to be repeated does not end after its beginning</source>
        <translation>la partie à répéter ne finit pas après son début</translation>
    </message>
    <message>
        <source>nothing is repeated; write a second label or ENDLABEL</source>
        <translation>rien n’est répété&#xa0;; programmez une seconde étiquette ou ENDLABEL</translation>
    </message>
    <message>
        <source>nothing is repeated; check the label</source>
        <translation>rien n’est répété&#xa0;; vérifiez l’étiquette</translation>
    </message>
    <message>
        <source>no extra turn is used</source>
        <translation>aucun tour de plus n’est fait</translation>
    </message>
    <message>
        <source>the arc has both a centre (I, J, K) and a radius (CR)</source>
        <translation>l’arc a un centre (I, J, K) et un rayon (CR)</translation>
    </message>
    <message>
        <source>CR is used; remove one of them</source>
        <translation>CR est utilisé&#xa0;; supprimez l’un des deux</translation>
    </message>
    <message>
        <source>the arc has neither a centre (I, J, K) nor a radius (CR)</source>
        <translation>l’arc n’a ni centre (I, J, K) ni rayon (CR)</translation>
    </message>
    <message>
        <source>start, intermediate point (I1, J1, K1) and end of CIP are on one line</source>
        <translation>le départ, le point intermédiaire (I1, J1, K1) et la fin de CIP sont alignés</translation>
    </message>
    <message>
        <source>CT without a preceding motion in its plane</source>
        <translation>CT sans déplacement précédent dans son plan</translation>
    </message>
    <message>
        <source>it is ignored; write a radius of zero or more</source>
        <translation>il est ignoré&#xa0;; programmez un rayon nul ou positif</translation>
    </message>
    <message>
        <source>the combined frames are out of range</source>
        <translation>les frames combinés dépassent les bornes</translation>
    </message>
    <message>
        <source>all of them are reset; check additive frames in loops</source>
        <translation>tous sont remis à zéro&#xa0;; vérifiez les frames additifs dans les boucles</translation>
    </message>
    <message>
        <source>corners stay sharp; write a radius or 0</source>
        <translation>les angles restent vifs&#xa0;; programmez un rayon ou 0</translation>
    </message>
    <message>
        <source>a rounding or chamfer in a block without a line or arc</source>
        <translation>un arrondi ou chanfrein dans un bloc sans droite ni arc</translation>
    </message>
    <message>
        <source>the corner stays sharp; write it in the block that ends at the corner</source>
        <translation>l’angle reste vif&#xa0;; programmez-le dans le bloc qui finit dans l’angle</translation>
    </message>
    <message>
        <source>as on controls with setting data 42440 at 1, the default; else program it absolute</source>
        <translation>comme sur les commandes dont la donnée de réglage 42440 vaut 1, le réglage d’origine&#xa0;; sinon programmez-le en absolu</translation>
    </message>
    <message>
        <source>the line ends at the given coordinates; program its end</source>
        <translation>la droite finit aux coordonnées données&#xa0;; programmez sa fin</translation>
    </message>
    <message>
        <source>it is used as the depth of the tip</source>
        <translation>elle est lue comme la profondeur de la pointe</translation>
    </message>
    <message>
        <source>the holes are skipped; correct the number</source>
        <translation>les trous sont ignorés&#xa0;; corrigez le nombre</translation>
    </message>
    <message>
        <source>its motion is skipped; call it after single positions</source>
        <translation>son déplacement est ignoré&#xa0;; appelez-le après des positions isolées</translation>
    </message>
    <message>
        <source>it is ignored; write a tolerance of zero or more and a code from 0 to 99999999</source>
        <translation>il est ignoré&#xa0;; programmez une tolérance nulle ou positive et un code de 0 à 99999999</translation>
    </message>
    <message>
        <source>write the type as the second value: 1 finishing, 2 semi-finishing, 3 roughing</source>
        <translation>programmez le type en deuxième valeur&#xa0;: 1 finition, 2 semi-finition, 3 ébauche</translation>
    </message>
    <message>
        <source>the plane is shown without rotation; program angles about one axis after the other</source>
        <translation>le plan est affiché sans rotation&#xa0;; programmez des angles autour d’un axe après l’autre</translation>
    </message>
    <message>
        <source>CYCLE800 says no direction (_DIR) of the rotary axes</source>
        <translation>CYCLE800 ne donne pas de sens (_DIR) des axes rotatifs</translation>
    </message>
    <message>
        <source>they turn the shortest way to the plane</source>
        <translation>ils tournent vers le plan par le chemin le plus court</translation>
    </message>
    <message>
        <source>the dwell is skipped; write F with seconds or S with revolutions</source>
        <translation>la temporisation est ignorée&#xa0;; programmez F en secondes ou S en tours</translation>
    </message>
    <message>
        <source>the dwell is skipped; write S in a block before it</source>
        <translation>la temporisation est ignorée&#xa0;; programmez S dans un bloc précédent</translation>
    </message>
    <message>
        <source>G1 is used; write the G word</source>
        <translation>G1 est utilisé&#xa0;; programmez le mot G</translation>
    </message>
    <message>
        <source>its feed is lead times spindle speed; the run-up of the spindle is not shown</source>
        <translation>son avance est le pas multiplié par la vitesse de broche&#xa0;; la montée en vitesse de la broche n’est pas montrée</translation>
    </message>
    <message>
        <source>write a distance of zero or more; the block does not move</source>
        <translation>programmez une distance nulle ou positive&#xa0;; le bloc n’a pas de déplacement</translation>
    </message>
    <message>
        <source>a denominator of polynomials is not supported</source>
        <translation>un dénominateur de polynômes n’est pas pris en charge</translation>
    </message>
    <message>
        <source>X, Y and Z are shown without it</source>
        <translation>X, Y et Z sont affichés sans cela</translation>
    </message>
    <message>
        <source>a polynomial has more than 5 coefficients</source>
        <translation>un polynôme a plus de 5 coefficients</translation>
    </message>
    <message>
        <source>the block does not move; write a polynomial of degree 5 or less</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; programmez un polynôme de degré 5 au plus</translation>
    </message>
    <message>
        <source>positioning axes in a block with a path motion are not supported</source>
        <translation>des axes de positionnement dans un bloc à déplacement sur trajectoire ne sont pas pris en charge</translation>
    </message>
    <message>
        <source>their motion is skipped; position them in a block of their own</source>
        <translation>leur déplacement est ignoré&#xa0;; positionnez-les dans un bloc à part</translation>
    </message>
    <message>
        <source>positioning axes are shown as a rapid on a straight line</source>
        <translation>des axes de positionnement sont affichés comme un rapide en ligne droite</translation>
    </message>
    <message>
        <source>a positioning axis is shown as a rapid</source>
        <translation>un axe de positionnement est affiché comme un rapide</translation>
    </message>
    <message>
        <source>each axis moves at its own speed, set by FA or the machine</source>
        <translation>chaque axe se déplace à sa propre vitesse, fixée par FA ou par la machine</translation>
    </message>
    <message>
        <source>1 is used</source>
        <translation>1 est utilisé</translation>
    </message>
    <message>
        <source>positions are skipped up to the next motion word</source>
        <translation>les positions sont ignorées jusqu’au prochain mot de déplacement</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour</source>
        <translation>la trajectoire affichée est le contour programmé</translation>
    </message>
    <message>
        <source>the limits of the machine file are used</source>
        <translation>les limites du fichier machine sont utilisées</translation>
    </message>
    <message>
        <source>compensation begins and ends on a straight line, as with NORM</source>
        <translation>la correction commence et finit sur une droite, comme avec NORM</translation>
    </message>
    <message>
        <source>3D cutter compensation</source>
        <translation>correction de rayon en 3D</translation>
    </message>
    <message>
        <source>the cutter is compensated in the plane</source>
        <translation>le rayon est corrigé dans le plan</translation>
    </message>
    <message>
        <source>thread with increasing lead</source>
        <translation>filetage à pas croissant</translation>
    </message>
    <message>
        <source>thread with decreasing lead</source>
        <translation>filetage à pas décroissant</translation>
    </message>
    <message>
        <source>involute</source>
        <translation>développante de cercle</translation>
    </message>
    <message>
        <source>tapping with compensating chuck</source>
        <translation>taraudage avec mandrin compensateur</translation>
    </message>
    <message>
        <source>a line at the programmed feed</source>
        <translation>une droite à l’avance programmée</translation>
    </message>
    <message>
        <source>the last spindle speed is used</source>
        <translation>la dernière vitesse de broche est utilisée</translation>
    </message>
    <message>
        <source>rotation by solid angles</source>
        <translation>rotation par angles solides</translation>
    </message>
    <message>
        <source>soft approach</source>
        <translation>approche en douceur</translation>
    </message>
    <message>
        <source>soft retraction</source>
        <translation>retrait en douceur</translation>
    </message>
    <message>
        <source>oblique plunge grinding</source>
        <translation>rectification en plongée oblique</translation>
    </message>
    <message>
        <source>ISO dialect</source>
        <translation>dialecte ISO</translation>
    </message>
    <message>
        <source>the following blocks are interpreted as Siemens code</source>
        <translation>les blocs suivants sont interprétés comme du code Siemens</translation>
    </message>
    <message>
        <source>cylinder surface transformation</source>
        <translation>transformation de surface cylindrique</translation>
    </message>
    <message>
        <source>face end transformation</source>
        <translation>transformation de face frontale</translation>
    </message>
    <message>
        <source>inclined axis</source>
        <translation>axe incliné</translation>
    </message>
    <message>
        <source>chained transformation</source>
        <translation>transformations en chaîne</translation>
    </message>
    <message>
        <source>frame in tool direction</source>
        <translation>frame dans la direction de l’outil</translation>
    </message>
    <message>
        <source>rotation in tool direction</source>
        <translation>rotation dans la direction de l’outil</translation>
    </message>
    <message>
        <source>alignment with the workpiece</source>
        <translation>alignement sur la pièce</translation>
    </message>
    <message>
        <source>feed by a polynomial</source>
        <translation>avance par polynôme</translation>
    </message>
    <message>
        <source>the feed does not change</source>
        <translation>l’avance ne change pas</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>the probe is assumed never to touch</source>
        <translation>le palpeur est supposé ne jamais toucher</translation>
    </message>
    <message>
        <source>coupled axes</source>
        <translation>axes couplés</translation>
    </message>
    <message>
        <source>tangential control</source>
        <translation>asservissement tangentiel</translation>
    </message>
    <message>
        <source>oscillating axes</source>
        <translation>axes oscillants</translation>
    </message>
    <message>
        <source>positioning axis</source>
        <translation>axe de positionnement</translation>
    </message>
    <message>
        <source>setting of actual values</source>
        <translation>forçage des valeurs réelles</translation>
    </message>
    <message>
        <source>change of geometry axes</source>
        <translation>changement d’axes géométriques</translation>
    </message>
    <message>
        <source>point-to-point motion</source>
        <translation>déplacement point à point</translation>
    </message>
    <message>
        <source>contour offset</source>
        <translation>décalage de contour</translation>
    </message>
    <message>
        <source>feed per tooth</source>
        <translation>avance par dent</translation>
    </message>
    <message>
        <source>the last feed is used; write F</source>
        <translation>la dernière avance est utilisée&#xa0;; programmez F</translation>
    </message>
    <message>
        <source>feed override</source>
        <translation>correction d’avance</translation>
    </message>
    <message>
        <source>the feed of F is used</source>
        <translation>l’avance de F est utilisée</translation>
    </message>
    <message>
        <source>override of rapids</source>
        <translation>correction des rapides</translation>
    </message>
    <message>
        <source>rapids of the machine are used</source>
        <translation>les rapides de la machine sont utilisés</translation>
    </message>
    <message>
        <source>set of dynamic limits</source>
        <translation>jeu de limites dynamiques</translation>
    </message>
    <message>
        <source>acceleration of an axis</source>
        <translation>accélération d’un axe</translation>
    </message>
    <message>
        <source>speed of an axis</source>
        <translation>vitesse d’un axe</translation>
    </message>
    <message>
        <source>jerk of an axis</source>
        <translation>jerk d’un axe</translation>
    </message>
    <message>
        <source>approach around the corner</source>
        <translation>approche autour de l’angle</translation>
    </message>
    <message>
        <source>approach on a curve</source>
        <translation>approche sur une courbe</translation>
    </message>
    <message>
        <source>overshoot at outside corners</source>
        <translation>dépassement aux angles saillants</translation>
    </message>
    <message>
        <source>they are rounded by a circle</source>
        <translation>ils sont arrondis par un cercle</translation>
    </message>
    <message>
        <source>tool radius offset</source>
        <translation>décalage du rayon d’outil</translation>
    </message>
    <message>
        <source>the radius does not change</source>
        <translation>le rayon ne change pas</translation>
    </message>
    <message>
        <source>block made of strings</source>
        <translation>bloc composé de chaînes</translation>
    </message>
    <message>
        <source>the block is skipped</source>
        <translation>le bloc est ignoré</translation>
    </message>
    <message>
        <source>execution of a contour table</source>
        <translation>exécution d’une table de contour</translation>
    </message>
    <message>
        <source>return to the contour</source>
        <translation>retour sur le contour</translation>
    </message>
    <message>
        <source>transformation</source>
        <translation>transformation active</translation>
    </message>
    <message>
        <source>machine builder function</source>
        <translation>fonction du constructeur de la machine</translation>
    </message>
    <message>
        <source>the program is not simulated; check the number, its decimal point and the unit</source>
        <translation>le programme n’est pas simulé&#xa0;; vérifiez le nombre, son point décimal et l’unité</translation>
    </message>
    <message>
        <source>there is no model of a Fanuc: that of another control runs its limits</source>
        <translation>il n’y a pas de modèle de Fanuc&#xa0;: celui d’une autre commande applique ses limites</translation>
    </message>
    <message>
        <source>the machine measures in inches (1001, bit 0), in which parameters are not imported; all limits are assumed</source>
        <translation>la machine mesure en pouces (1001, bit 0), unité dans laquelle les paramètres ne sont pas importés&#xa0;; toutes les limites sont supposées</translation>
    </message>
    <message>
        <source>write its limits into a machine file</source>
        <translation>écrivez ses limites dans un fichier machine</translation>
    </message>
    <message>
        <source>which axes X, Y and Z are is not told; the first three are assumed</source>
        <translation>il n’est pas dit quels axes sont X, Y et Z&#xa0;; les trois premiers sont supposés</translation>
    </message>
    <message>
        <source>add parameter 1020</source>
        <translation>ajoutez le paramètre 1020</translation>
    </message>
    <message>
        <source>time constant of rapids</source>
        <translation>constante de temps des rapides</translation>
    </message>
    <message>
        <source>time constant of cutting feeds after interpolation</source>
        <translation>constante de temps des avances de coupe après interpolation</translation>
    </message>
    <message>
        <source>acceleration of rapids</source>
        <translation>accélération des rapides</translation>
    </message>
    <message>
        <source>time in which the acceleration of rapids is reached</source>
        <translation>durée d’établissement de l’accélération des rapides</translation>
    </message>
    <message>
        <source>feed below which arcs do not slow down</source>
        <translation>avance au-dessous de laquelle les arcs ne ralentissent pas</translation>
    </message>
    <message>
        <source>acceleration on arcs</source>
        <translation>accélération sur les arcs</translation>
    </message>
    <message>
        <source>acceleration under look-ahead control</source>
        <translation>accélération sous commande anticipée</translation>
    </message>
    <message>
        <source>time constant after interpolation under look-ahead control</source>
        <translation>constante de temps après interpolation sous commande anticipée</translation>
    </message>
    <message>
        <source>difference of feeds that is passed at corners without slowing down</source>
        <translation>écart d’avance passé aux angles sans ralentir</translation>
    </message>
    <message>
        <source>change of acceleration that is passed without slowing down</source>
        <translation>variation d’accélération passée sans ralentir</translation>
    </message>
    <message>
        <source>indices 0, 1 and 2 are taken as X, Y and Z</source>
        <translation>les indices 0, 1 et 2 sont pris comme X, Y et Z</translation>
    </message>
    <message>
        <source>exchange the axes in the machine file where that is not so</source>
        <translation>échangez les axes dans le fichier machine si ce n’est pas le cas</translation>
    </message>
    <message>
        <source>the basic system is inch, in which machine data are not imported; all limits are assumed</source>
        <translation>le système de base est le pouce, dans lequel les données machine ne sont pas importées&#xa0;; toutes les limites sont supposées</translation>
    </message>
    <message>
        <source>export the machine data with MD10240 = 1</source>
        <translation>exportez les données machine avec MD10240 = 1</translation>
    </message>
    <message>
        <source>which machine axes X, Y and Z are is not told; AX1, AX2 and AX3 are assumed</source>
        <translation>il n’est pas dit quels axes machine sont X, Y et Z&#xa0;; AX1, AX2 et AX3 sont supposés</translation>
    </message>
    <message>
        <source>add MD20050 to MD20080 of the channel</source>
        <translation>ajoutez MD20050 à MD20080 du canal</translation>
    </message>
    <message>
        <source>change it in the machine file for programs that finish with another mode</source>
        <translation>changez-la dans le fichier machine pour les programmes qui finissent dans un autre mode</translation>
    </message>
    <message>
        <source>the settings are numbered as in grbl 0.8 and before, which is not supported</source>
        <translation>les réglages sont numérotés comme dans grbl 0.8 et avant, ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>update the control, or write its values into a machine file</source>
        <translation>mettez la commande à jour, ou écrivez ses valeurs dans un fichier machine</translation>
    </message>
    <message>
        <source>laser mode ($32 = 1) is not modelled: with a laser, changes of S do not stop the motion</source>
        <translation>le mode laser ($32 = 1) n’est pas modélisé&#xa0;: avec un laser, les changements de S n’arrêtent pas le déplacement</translation>
    </message>
    <message>
        <source>a setting that no model here uses; skipped</source>
        <translation>un réglage qu’aucun modèle n’utilise ici&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>axes other than X, Y and Z are not part of the simulation; skipped</source>
        <translation>les axes autres que X, Y et Z ne font pas partie de la simulation&#xa0;; ignorés</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>supprimez l’un des deux</translation>
    </message>
    <message>
        <source>section [printer] is missing; its limits are assumed</source>
        <translation>la section [printer] manque&#xa0;; ses limites sont supposées</translation>
    </message>
    <message>
        <source>import the file that Klipper itself reads, printer.cfg</source>
        <translation>importez le fichier que Klipper lit lui-même, printer.cfg</translation>
    </message>
    <message>
        <source>there is no section [gcode_arcs]: this Klipper does not know G2 and G3, while the model runs them</source>
        <translation>il n’y a pas de section [gcode_arcs]&#xa0;: ce Klipper ne connaît pas G2 et G3, alors que le modèle les exécute</translation>
    </message>
    <message>
        <source>add [gcode_arcs], or let the CAM system write lines</source>
        <translation>ajoutez [gcode_arcs], ou faites écrire des droites par la FAO</translation>
    </message>
    <message>
        <source>input shaping is not modelled: it smooths the motion and takes no longer on the whole</source>
        <translation>l’input shaping n’est pas modélisé&#xa0;: il lisse le déplacement sans prendre plus de temps au total</translation>
    </message>
    <message>
        <source>[TRAJ] LINEAR_UNITS is missing; mm is assumed</source>
        <translation>[TRAJ] LINEAR_UNITS manque&#xa0;; le mm est supposé</translation>
    </message>
    <message>
        <source>write LINEAR_UNITS = mm or inch</source>
        <translation>écrivez LINEAR_UNITS = mm ou inch</translation>
    </message>
    <message>
        <source>the joint cannot follow there: lower the limit of the axis</source>
        <translation>l’articulation (joint) ne peut pas suivre&#xa0;: réduisez la limite de l’axe</translation>
    </message>
    <message>
        <source>write G64 P into the program, or set blend_tolerance_mm if your release takes it</source>
        <translation>programmez G64 P dans le programme, ou réglez blend_tolerance_mm si votre version en tient compte</translation>
    </message>
    <message>
        <source>write them into the machine file: [kinematics], &apos;point&apos; of each axis</source>
        <translation>écrivez-les dans le fichier machine&#xa0;: [kinematics], &apos;point&apos; de chaque axe</translation>
    </message>
    <message>
        <source>correct the file of the control; until then the value is assumed</source>
        <translation>corrigez le fichier de la commande&#xa0;; d’ici là, la valeur est supposée</translation>
    </message>
    <message>
        <source>correct what is listed, and import the file once more</source>
        <translation>corrigez ce qui est affiché, puis importez de nouveau le fichier</translation>
    </message>
    <message>
        <source>values that stand there are missing here</source>
        <translation>les valeurs qui s’y trouvent manquent ici</translation>
    </message>
    <message>
        <source>no file is named</source>
        <translation>aucun fichier n’est nommé</translation>
    </message>
    <message>
        <source>only the text itself is at hand</source>
        <translation>seul le texte lui-même est disponible</translation>
    </message>
    <message>
        <source>it includes itself</source>
        <translation>il s’inclut lui-même</translation>
    </message>
    <message>
        <source>The positions go together better with a delay between set and actual ones than without, which cannot be told from a following error: record both in one cycle.</source>
        <translation>Les positions vont mieux ensemble avec un décalage entre consignes et positions réelles que sans, ce qui ne se distingue pas d’un écart de poursuite : les enregistrer dans un même cycle.</translation>
    </message>
    <message>
        <source>a word must begin with a letter</source>
        <translation>un mot doit commencer par une lettre</translation>
    </message>
    <message>
        <source>a letter has no number</source>
        <translation>une lettre est sans nombre</translation>
    </message>
    <message>
        <source>system commands are not part of a program</source>
        <translation>les commandes du système n’ont pas leur place dans un programme</translation>
    </message>
    <message>
        <source>the value must not be negative</source>
        <translation>la valeur ne doit pas être négative</translation>
    </message>
    <message>
        <source>the line has more than 79 characters</source>
        <translation>la ligne compte plus de 79 caractères</translation>
    </message>
    <message>
        <source>the command is not supported</source>
        <translation>la commande n’est pas prise en charge</translation>
    </message>
    <message>
        <source>two commands of one group</source>
        <translation>deux commandes du même groupe</translation>
    </message>
    <message>
        <source>no feed is given</source>
        <translation>aucune avance n’est donnée</translation>
    </message>
    <message>
        <source>the number of the command must be whole</source>
        <translation>le numéro de la commande doit être entier</translation>
    </message>
    <message>
        <source>two commands both use the axis words</source>
        <translation>deux commandes utilisent toutes deux les mots d’axe</translation>
    </message>
    <message>
        <source>a word is repeated</source>
        <translation>un mot est répété</translation>
    </message>
    <message>
        <source>axis words of the plane are missing</source>
        <translation>il manque les mots d’axe du plan</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>il manque une valeur</translation>
    </message>
    <message>
        <source>the work offset does not exist</source>
        <translation>le décalage d’origine n’existe pas</translation>
    </message>
    <message>
        <source>G53 needs G0 or G1</source>
        <translation>G53 demande G0 ou G1</translation>
    </message>
    <message>
        <source>axis words without a command that uses them</source>
        <translation>mots d’axe sans commande qui les utilise</translation>
    </message>
    <message>
        <source>the arc does not fit its end point</source>
        <translation>l’arc ne correspond pas à son point final</translation>
    </message>
    <message>
        <source>the radius is smaller than half the distance of the ends</source>
        <translation>le rayon est inférieur à la moitié de la distance entre les extrémités</translation>
    </message>
    <message>
        <source>centre offsets of the plane are missing</source>
        <translation>il manque les décalages du centre dans le plan</translation>
    </message>
    <message>
        <source>a word is not used by any command of the line</source>
        <translation>un mot n’est utilisé par aucune commande de la ligne</translation>
    </message>
    <message>
        <source>G43.1 takes Z only</source>
        <translation>G43.1 n’accepte que Z</translation>
    </message>
    <message>
        <source>the tool number is too large</source>
        <translation>le numéro d’outil est trop grand</translation>
    </message>
    <message>
        <source>the line is not accepted</source>
        <translation>la ligne n’est pas acceptée</translation>
    </message>
    <message>
        <source>F of G93</source>
        <translation>F de G93</translation>
    </message>
    <message>
        <source>P of G4</source>
        <translation>P de G4</translation>
    </message>
    <message>
        <source>P of G10</source>
        <translation>P de G10</translation>
    </message>
    <message>
        <source>L or P of G10</source>
        <translation>L ou P de G10</translation>
    </message>
    <message>
        <source>G20: inches are not supported</source>
        <translation>G20&#xa0;: les pouces ne sont pas pris en charge</translation>
    </message>
    <message>
        <source>invalid speed F</source>
        <translation>vitesse F non valide</translation>
    </message>
    <message>
        <source>arcs need absolute coordinates</source>
        <translation>les arcs demandent des coordonnées absolues</translation>
    </message>
    <message>
        <source>arcs by radius are not supported</source>
        <translation>les arcs par rayon ne sont pas pris en charge</translation>
    </message>
    <message>
        <source>invalid time P</source>
        <translation>temps P non valide</translation>
    </message>
    <message>
        <source>invalid factor S</source>
        <translation>facteur S non valide</translation>
    </message>
    <message>
        <source>M204 needs S, or P and T</source>
        <translation>M204 demande S, ou P et T</translation>
    </message>
    <message>
        <source>machine file</source>
        <translation>fichier de machine</translation>
    </message>
    <message>
        <source>load file</source>
        <translation>fichier de charge</translation>
    </message>
    <message>
        <source>file of materials</source>
        <translation>fichier de matières</translation>
    </message>
    <message>
        <source>lesson</source>
        <translation>leçon</translation>
    </message>
    <message>
        <source>configuration of a control</source>
        <translation>configuration d’une commande</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>configuration</translation>
    </message>
    <message>
        <source>table of section times</source>
        <translation>table de temps de sections</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>aucun fichier ou dossier de ce nom</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>accès refusé</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>il n’y a plus de place sur le support</translation>
    </message>
    <message>
        <source>no title of a column says which are the positions of X, Y and Z</source>
        <translation>aucun titre de colonne n’indique les positions de X, Y et Z</translation>
    </message>
    <message>
        <source>the columns have no titles</source>
        <translation>les colonnes n’ont pas de titres</translation>
    </message>
    <message>
        <source>all tools</source>
        <translation>tous les outils</translation>
    </message>
    <message>
        <source>&apos;lines&apos; must be ranges of lines of the program in quotes, such as &quot;10-25&quot; or &quot;10-25, 40-52&quot;</source>
        <translation>&apos;lines&apos; doit donner des plages de lignes du programme entre guillemets, comme &quot;10-25&quot; ou &quot;10-25, 40-52&quot;</translation>
    </message>
    <message>
        <source>&apos;tool&apos; must be its number, or its name in quotes, as the program calls it</source>
        <translation>&apos;tool&apos; doit être son numéro, ou son nom entre guillemets, tel que le programme l’appelle</translation>
    </message>
    <message>
        <source>the file has no operation; add an [[operation]] with tool, diameter_mm, teeth, helix_deg, ae_mm, ap_mm, milling and material</source>
        <translation>le fichier n’a pas d’opération&#xa0;; ajoutez une [[operation]] avec tool, diameter_mm, teeth, helix_deg, ae_mm, ap_mm, milling et material</translation>
    </message>
    <message>
        <source>identification needs at least one trace</source>
        <translation>l’identification demande au moins une trace</translation>
    </message>
    <message>
        <source>it names no program: &quot;program&quot; has no &quot;file&quot;</source>
        <translation>elle ne nomme pas de programme&#xa0;: &quot;program&quot; n’a pas de &quot;file&quot;</translation>
    </message>
    <message>
        <source>it has no runs: &quot;runs&quot; is empty or missing</source>
        <translation>elle n’a pas de simulations&#xa0;: &quot;runs&quot; est vide ou absent</translation>
    </message>
    <message>
        <source>not everything could be written; is there room for it?</source>
        <translation>tout n’a pas pu être écrit&#xa0;; y a-t-il assez de place&#xa0;?</translation>
    </message>
    <message>
        <source>this build of Feedscope has no Theora video</source>
        <translation>cette version de Feedscope est sans vidéo Theora</translation>
    </message>
    <message>
        <source>the program does not move, so that there is nothing to film</source>
        <translation>le programme ne se déplace pas&#xa0;: il n’y a rien à filmer</translation>
    </message>
    <message>
        <source>feeds, ramps and corners contain what the drives do; record the set positions too to tell them apart</source>
        <translation>avances, rampes et angles contiennent ce que font les entraînements&#xa0;; enregistrez aussi les positions de consigne pour les distinguer</translation>
    </message>
    <message>
        <source>Where rotary axes turn the bound is not strict: they hold the tip over each whole block by their fastest place, along curves and where blocks meet by their velocity and by what turning takes, not while the tip speeds up; turns between operations take the time of the machine&apos;s jerk.</source>
        <translation>Là où des axes rotatifs tournent, ce n’est pas une borne stricte&#xa0;: ils retiennent la pointe sur tout le bloc d’après leur endroit le plus rapide, le long des courbes et aux jonctions de blocs d’après leur vitesse et ce que demande la rotation, mais pas pendant que la pointe accélère&#xa0;; les rotations entre opérations prennent le temps du jerk de la machine.</translation>
    </message>
    <message>
        <source>recorders that write changes alone leave them out</source>
        <translation>les enregistreurs qui n’écrivent que les changements les omettent</translation>
    </message>
    <message>
        <source>it is not compared; the others are right</source>
        <translation>il n’est pas comparé ; les autres sont justes</translation>
    </message>
    <message>
        <source>samples are missing there without a gap in the times: all later times, and the cycle time, are too short by an unknown time</source>
        <translation>des échantillons y manquent sans lacune dans les temps : tous les temps suivants, et le temps de cycle, sont trop courts d’une durée inconnue</translation>
    </message>
    <message>
        <source>check how the trace was recorded</source>
        <translation>vérifiez comment la trace a été enregistrée</translation>
    </message>
    <message>
        <source>swing about the tip</source>
        <translation>pivotement autour de la pointe</translation>
    </message>
    <message>
        <source>swing about the tip, held by axis %1</source>
        <translation>pivotement autour de la pointe, retenu par l’axe %1</translation>
    </message>
    <message>
        <source>the tool retracts to the end of travel before the axes turn (MB MAX)</source>
        <translation>l’outil se dégage jusqu’en fin de course avant que les axes tournent (MB MAX)</translation>
    </message>
    <message>
        <source>this motion is neither drawn nor timed, nor is the way back</source>
        <translation>ce mouvement n’est ni tracé ni compté, le retour non plus</translation>
    </message>
    <message>
        <source>X, Y and Z move while the rotary axes turn (MOVE)</source>
        <translation>X, Y et Z se déplacent pendant que les axes rotatifs tournent (MOVE)</translation>
    </message>
    <message>
        <source>this motion is neither drawn nor timed</source>
        <translation>ce mouvement n’est ni tracé ni compté</translation>
    </message>
    <message>
        <source>where to, the machine&apos;s data says: this motion is neither drawn nor timed</source>
        <translation>jusqu’où, les données de la machine le disent : ce mouvement n’est ni tracé ni compté</translation>
    </message>
    <message>
        <source>The model leaves over more than noise and sampling of these traces make: another value may explain them.</source>
        <translation>Le modèle laisse plus que ne font le bruit et l’échantillonnage de ces traces : une autre valeur peut les expliquer.</translation>
    </message>
    <message>
        <source>they seem to be in ms: give their column the title ms</source>
        <translation>ils semblent être en ms : donner à leur colonne le titre ms</translation>
    </message>
    <message>
        <source>they seem to be in s: give their column the title seconds</source>
        <translation>ils semblent être en s : donner à leur colonne le titre seconds</translation>
    </message>
    <message>
        <source>they seem to be in minutes: write them in seconds</source>
        <translation>ils semblent être en minutes : les écrire en secondes</translation>
    </message>
    <message>
        <source>give the program that ran, and its times in seconds, or in ms under this title</source>
        <translation>donner le programme exécuté, et ses temps en secondes, ou en ms sous ce titre</translation>
    </message>
    <message>
        <source>a feed hold, or a stop that the simulation does not know; half a second before and after it is not compared, and its time not counted</source>
        <translation>un arrêt d’avance, ou un arrêt que la simulation ne connaît pas ; une demi-seconde avant et après n’est pas comparée, et son temps n’est pas compté</translation>
    </message>
    <message>
        <source>the times jitter by more than a period: record the time of the control&apos;s cycle</source>
        <translation>les temps varient de plus d’une période : enregistrer le temps du cycle de la commande</translation>
    </message>
    <message>
        <source>Only zero, which stands for no limit, explains these traces.</source>
        <translation>Seul zéro, qui signifie sans limite, explique ces traces.</translation>
    </message>
    <message>
        <source>It changes with the steps a millimetre, which are assumed: give those of the machine.</source>
        <translation>Elle change avec les pas par millimètre, qui sont supposés&#xa0;: donner ceux de la machine.</translation>
    </message>
    <message>
        <source>Assumed, but it explains the recordings much better than what was assumed before.</source>
        <translation>Supposé, mais explique les enregistrements bien mieux que ce qui était supposé auparavant.</translation>
    </message>
    <message>
        <source>a feed hold, or a stop that the simulation does not know; its time is in that of the trace</source>
        <translation>un arrêt d’avance, ou un arrêt que la simulation ne connaît pas&#xa0;; sa durée est comprise dans celle de la trace</translation>
    </message>
    <message>
        <source>Feed override</source>
        <translation>Correction d’avance</translation>
    </message>
    <message>
        <source>Largest velocity of this axis in feed moves, where the control has one below that of its rapids; without it, or 0, the velocity of the axis.</source>
        <translation>Plus grande vitesse de cet axe en déplacements avec avance, lorsque la commande en a une inférieure à celle des rapides&#xa0;; sans elle, ou 0, la vitesse de l’axe.</translation>
    </message>
    <message>
        <source>All feeds of the program in percent of what it says, as the dial of the control sets them; rapids stay. Without it 100 %.</source>
        <translation>Toutes les avances du programme en pour cent de ce qu’il dit, comme les règle le potentiomètre de la commande ; les rapides restent. Sans elle, 100 %.</translation>
    </message>
    <message>
        <source>on: where the program asks for a tolerance (CTOL, CYCLE832, G64 P, cycle 32) or a blend distance (ADIS), it is used; off: that of the settings is used everywhere. Exact stops are always used.</source>
        <translation>oui&#xa0;: là où le programme demande une tolérance (CTOL, CYCLE832, G64 P, cycle 32) ou une distance de raccord (ADIS), c’est elle qui vaut&#xa0;; non&#xa0;: celle des réglages vaut partout. Les arrêts précis sont toujours respectés.</translation>
    </message>
    <message>
        <source>give the right rate or unit of its times; else limits that are found from the trace are wrong</source>
        <translation>donnez la bonne cadence ou la bonne unité de ses temps&#xa0;; sinon les limites trouvées d’après la trace sont fausses</translation>
    </message>
    <message>
        <source>a feed override, or times of another rate: set the feed override of the simulation to it, or give the right rate; else limits that are found from the trace are those of the override</source>
        <translation>une correction d’avance, ou des temps d’une autre cadence&#xa0;: réglez la correction d’avance de la simulation sur cette valeur, ou donnez la bonne cadence&#xa0;; sinon les limites trouvées d’après la trace sont celles de la correction</translation>
    </message>
    <message>
        <source>give its column a minus sign, as --columns time=1,x=2:-mm</source>
        <translation>donnez un signe moins à sa colonne, comme --columns time=1,x=2:-mm</translation>
    </message>
    <message>
        <source>the trace runs along the path of this program from its end to its start</source>
        <translation>la trace parcourt le trajet de ce programme de sa fin à son début</translation>
    </message>
    <message>
        <source>simulate the program that was recorded, with its blocks in the order that the control ran them in</source>
        <translation>simulez le programme qui a été enregistré, avec ses blocs dans l’ordre où la commande les a exécutés</translation>
    </message>
    <message>
        <source>its times are in milliseconds: give their column the unit, as --columns time=1:ms</source>
        <translation>ses instants sont en millisecondes&#xa0;: donnez l’unité à leur colonne, comme --columns time=1:ms</translation>
    </message>
    <message>
        <source>name the columns in this order; for X and Y exchanged, as --columns time=1,x=3,y=2,z=4</source>
        <translation>nommez les colonnes dans cet ordre&#xa0;; pour X et Y échangés, comme --columns time=1,x=3,y=2,z=4</translation>
    </message>
    <message>
        <source>A smaller gain with feed-forward and lag explains the traces as well as the gain alone, which is used. If the control has no velocity feed-forward, look for the gain alone.</source>
        <translation>Un gain plus petit avec anticipation et retard explique aussi bien les traces que le gain seul, qui est utilisé. Si la commande n’a pas d’anticipation de vitesse, cherchez le gain seul.</translation>
    </message>
    <message>
        <source>The traces run at this share of the programmed feed. It is taken as the feed override, and is not written into the machine file. If the recorded times have a wrong rate instead, the other values are wrong.</source>
        <translation>Les traces vont à cette part de l’avance programmée. Elle est prise comme correction d’avance et n’est pas écrite dans le fichier machine. Si la cadence des instants enregistrés est plutôt fausse, les autres valeurs sont fausses.</translation>
    </message>
    <message>
        <source>The exact stop window has no effect: the machine gives no drive (kv_1_s), so that its axes are where they should be at once.</source>
        <translation>La fenêtre d’arrêt précis est sans effet : la machine ne donne aucun entraînement (kv_1_s), ses axes sont donc aussitôt à leur place.</translation>
    </message>
    <message>
        <source>block time</source>
        <translation>temps de bloc</translation>
    </message>
    <message>
        <source>Block time</source>
        <translation>Temps de bloc</translation>
    </message>
    <message>
        <source>Least time that the control takes to prepare a block: the feed on a block is at most its length by this time. Without it, or 0, blocks are prepared at once.</source>
        <translation>Temps minimal que la commande met à préparer un bloc : l’avance sur un bloc est au plus sa longueur divisée par ce temps. Sans valeur, ou 0, les blocs sont prêts aussitôt.</translation>
    </message>
    <message>
        <source>Exact stop window</source>
        <translation>Fenêtre d’arrêt précis</translation>
    </message>
    <message>
        <source>At exact stops (G9, G60 with G601 or G602, G61), before pauses and at the end the control waits until every axis is within this distance of its set position, by the gain of its drive. Without it, or 0, it does not wait.</source>
        <translation>Aux arrêts précis (G9, G60 avec G601 ou G602, G61), avant les pauses et à la fin, la commande attend que chaque axe soit à moins de cette distance de sa consigne, selon le gain de son entraînement. Sans valeur, ou 0, elle n’attend pas.</translation>
    </message>
    <message>
        <source>Blocks in which rotary axes turn alone are run from stop to stop; under G64 the control overlaps them with their neighbours, which saves up to 0.4 s each.</source>
        <translation>Les blocs où des axes rotatifs tournent seuls vont d’un arrêt à l’autre ; sous G64, la commande les recouvre avec leurs voisins, ce qui gagne jusqu’à 0,4 s chacun.</translation>
    </message>
    <message>
        <source>At M7, M8 and M9 the control waits for its coolant, often 0.1 s each time: not in the cycle time.</source>
        <translation>À M7, M8 et M9, la commande attend son arrosage, souvent 0,1 s chaque fois : hors du temps de cycle.</translation>
    </message>
    <message>
        <source>The machining mode of the program (type of CYCLE832, HSC-MODE, P of G187, R of G5.1) changes nothing: what it selects exists only in the control. Compare modes by acceleration and jerk of the machine.</source>
        <translation>Le mode d’usinage du programme (type de CYCLE832, HSC-MODE, P de G187, R de G5.1) ne change rien : ce qu’il choisit n’existe que dans la commande. Comparer les modes par l’accélération et le jerk de la machine.</translation>
    </message>
    <message>
        <source>G5.1 Q2 (smooth interpolation) is not supported</source>
        <translation>G5.1 Q2 (interpolation lisse) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>its blocks are run as lines; the setting compressor=on smooths them within the tolerance, but not by the control&apos;s own curve</source>
        <translation>ses blocs sont parcourus en droites ; le réglage compressor=on les lisse dans la tolérance, mais pas par la courbe propre à la commande</translation>
    </message>
    <message>
        <source>as it is, the trace is nowhere on this program: {}; {}</source>
        <translation>telle quelle, la trace n’est nulle part sur ce programme&#xa0;: {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>the trace is nowhere within {:.3g} mm of the path of the program; it is of another program, or its zero point is another</source>
        <translation>la trace n’est nulle part à moins de {} mm de la trajectoire du programme&#xa0;; elle est d’un autre programme, ou son origine est autre</translation>
    </message>
    <message>
        <source>the trace runs at {:.3g} % of the programmed feed: its sampling rate is wrong, or a feed override was set</source>
        <translation>la trace va à {} % de l’avance programmée&#xa0;: sa cadence d’échantillonnage est fausse, ou une correction d’avance était réglée</translation>
    </message>
    <message>
        <source>where the simulation runs at the programmed feed, the trace runs at {:.3g} % of it</source>
        <translation>là où la simulation suit l’avance programmée, la trace va à {} % de celle-ci</translation>
    </message>
    <message>
        <source>give the right rate, at most {0:.0f} samples a second, as --columns linuxcnc,rate={0:.0f}; or set the feed override of the simulation</source>
        <translation>donnez la bonne cadence, au plus {0} échantillons par seconde, comme --columns linuxcnc,rate={0}&#xa0;; ou réglez la correction d’avance de la simulation</translation>
    </message>
    <message>
        <source>give the right rate, {0:.0f} samples a second, as --columns linuxcnc,rate={0:.0f}; else limits that are found from the trace are wrong</source>
        <translation>donnez la bonne cadence, {0} échantillons par seconde, comme --columns linuxcnc,rate={0}&#xa0;; sinon les limites trouvées d’après la trace sont fausses</translation>
    </message>
    <message>
        <source>the trace runs at {:.3g} % of the simulated feed at even speed and where the machine speeds up or slows down: its sampling rate is wrong</source>
        <translation>la trace va à {} % de l’avance simulée, à vitesse constante comme là où la machine accélère ou ralentit&#xa0;: sa cadence d’échantillonnage est fausse</translation>
    </message>
    <message>
        <source>the trace stands still for {:.3g} % of the time of the dwells of the program: its sampling rate is wrong</source>
        <translation>la trace reste immobile pendant {} % du temps des temporisations du programme&#xa0;: sa cadence d’échantillonnage est fausse</translation>
    </message>
    <message>
        <source>the trace stands still for {:.3g} s from {:.4g} s on at line {}, where the program does not</source>
        <translation>la trace reste immobile pendant {} s à partir de {} s à la ligne {}, où le programme ne s’arrête pas</translation>
    </message>
    <message>
        <source>the trace stands still in {} more places, for {:.3g} s in all</source>
        <translation>la trace reste immobile en {} autres endroits, pendant {} s en tout</translation>
    </message>
    <message>
        <source>the trace fits this program with its axes in another order: its {} as X, its {} as Y, its {} as Z</source>
        <translation>la trace convient à ce programme avec ses axes dans un autre ordre&#xa0;: son {} comme X, son {} comme Y, son {} comme Z</translation>
    </message>
    <message>
        <source>the trace has the shape of this program, {:.4g} times as large</source>
        <translation>la trace a la forme de ce programme, {} fois plus grande</translation>
    </message>
    <message>
        <source>give each of its axes the unit, as --columns time=1,x=2:{0},y=3:{0},z=4:{0}</source>
        <translation>donnez l’unité à chacun de ses axes, comme --columns time=1,x=2:{0},y=3:{0},z=4:{0}</translation>
    </message>
    <message>
        <source>the trace fits this program with {} in the other direction</source>
        <translation>la trace convient à ce programme avec {} dans l’autre sens</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>ligne {}</translation>
    </message>
    <message>
        <source>lines {} to {}</source>
        <translation>lignes {} à {}</translation>
    </message>
    <message>
        <source>axis {} of the trace is mirrored; it is used with the other sign</source>
        <translation>l’axe {} de la trace est inversé&#xa0;; il est utilisé avec le signe contraire</translation>
    </message>
    <message>
        <source>axis {} does not move in the trace, but by {:.4g} mm in the program</source>
        <translation>l’axe {} ne bouge pas dans la trace, mais de {} mm dans le programme</translation>
    </message>
    <message>
        <source>the trace does not have {}, which the program moves: feeds, corners and distances are those of {} alone</source>
        <translation>il manque à la trace {}, que le programme déplace&#xa0;: avances, angles et distances sont ceux de {} seulement</translation>
    </message>
    <message>
        <source>{:.4g} s from {:.4g} s on at {}</source>
        <translation>{} s à partir de {} s, {}</translation>
    </message>
    <message>
        <source>{:.4g} s in {} stretches, the longest from {:.4g} s on at {}</source>
        <translation>{} s (tronçons&#xa0;: {}), le plus long à partir de {} s, {}</translation>
    </message>
    <message>
        <source>the trace is farther than {:.3g} mm from the path of the program for {}</source>
        <translation>la trace est à plus de {} mm de la trajectoire du programme pendant {}</translation>
    </message>
    <message>
        <source>nothing was recorded for {}</source>
        <translation>rien n’a été enregistré pendant {}</translation>
    </message>
    <message>
        <source>the trace does not belong to this program: {:.1f} % of its way runs along the path, and along {:.1f} % of it</source>
        <translation>la trace n’est pas celle de ce programme&#xa0;: {} % de son parcours suit la trajectoire, et {} % de celle-ci est suivi</translation>
    </message>
    <message>
        <source>the trace covers {:.1f} % of the path of the program, {}; only that is compared</source>
        <translation>la trace couvre {} % de la trajectoire du programme, {}&#xa0;; seule cette partie est comparée</translation>
    </message>
    <message>
        <source>the trace holds {} passes through the program; the first is compared</source>
        <translation>la trace contient {} passages du programme&#xa0;; le premier est comparé</translation>
    </message>
    <message>
        <source>{} goes to {:.4g} km, beyond the travel of any machine</source>
        <translation>{} va à {} km, au-delà de la course de toute machine</translation>
    </message>
    <message>
        <source>a motion of {:.4g} km is longer than any machine makes</source>
        <translation>un déplacement de {} km est plus long que sur toute machine</translation>
    </message>
    <message>
        <source>{:.4g} days pass up to this line, which runs at F{:.4g} mm/min: more than a year</source>
        <translation>{} jours passent jusqu’à cette ligne, parcourue à F{} mm/min&#xa0;: plus d’un an</translation>
    </message>
    <message>
        <source>{:.4g} days pass up to this line, which waits for {:.4g} of them: more than a year</source>
        <translation>{} jours passent jusqu’à cette ligne, dont {} d’attente dans celle-ci&#xa0;: plus d’un an</translation>
    </message>
    <message>
        <source>a rotary axis goes to {:.4g} degrees, beyond what any machine turns</source>
        <translation>un axe rotatif va à {} degrés, plus que ne tourne aucune machine</translation>
    </message>
    <message>
        <source>Heidenhain advises a contour tolerance of 110 to 200 % of the chord error: {:.2g} to {:.2g} mm</source>
        <translation>Heidenhain conseille une tolérance de contour de 110 à 200 % de l’erreur de corde&#xa0;: {} à {} mm</translation>
    </message>
    <message>
        <source>short lines lie about {:.2g} mm from the curve that they stand for: chord error, estimated from {} lines</source>
        <translation>des petits segments sont à environ {} mm de la courbe qu’ils remplacent&#xa0;: erreur de corde, estimée sur {} segments</translation>
    </message>
    <message>
        <source>The program has {} full circles; the first {} are evaluated.</source>
        <translation>Le programme contient {} cercles complets&#xa0;; les {} premiers sont évalués.</translation>
    </message>
    <message>
        <source>Not evaluated: {} helices with full turns.</source>
        <translation>Non évalué&#xa0;: {} hélices à tours complets.</translation>
    </message>
    <message>
        <source>Not evaluated: {} full circles outside the planes XY, ZX and YZ.</source>
        <translation>Non évalué&#xa0;: {} cercles complets hors des plans XY, ZX et YZ.</translation>
    </message>
    <message>
        <source>radius = {} mm is out of bounds; it must be at least 0.001 mm and at most {} mm</source>
        <translation>rayon = {} mm hors limites&#xa0;; il doit être d’au moins 0,001 mm et d’au plus {} mm</translation>
    </message>
    <message>
        <source>feed = {} mm/min is out of bounds; it must be above 0 mm/min</source>
        <translation>avance = {} mm/min hors limites&#xa0;; elle doit être supérieure à 0 mm/min</translation>
    </message>
    <message>
        <source>sweep = {} degrees is out of bounds; it must be above 0 and at most 360</source>
        <translation>angle = {} degrés hors limites&#xa0;; il doit être supérieur à 0 et d’au plus 360</translation>
    </message>
    <message>
        <source>entry radius = {} mm is out of bounds; it must be at least 0 mm and at most the radius of {} mm</source>
        <translation>rayon d’entrée = {} mm hors limites&#xa0;; il doit être d’au moins 0 mm et au plus du rayon de {} mm</translation>
    </message>
    <message>
        <source>The program is written for {}, but {} has a {}: path and times are those of that control. No published machine has a {} control; use your own machine file.</source>
        <translation>Le programme est écrit pour {}, mais {} a une {}&#xa0;: trajectoire et temps sont ceux de cette commande. Aucune machine publiée n’a de commande {}&#xa0;; utilisez votre propre fichier de machine.</translation>
    </message>
    <message>
        <source>The program is written for {}, but {} has a {}: path and times are those of that control. Use machine {}, whose control reads it.</source>
        <translation>Le programme est écrit pour {}, mais {} a une {}&#xa0;: trajectoire et temps sont ceux de cette commande. Utilisez la machine {}, dont la commande le lit.</translation>
    </message>
    <message>
        <source>{} tool change</source>
        <translation>{} changement d’outil</translation>
    </message>
    <message>
        <source>{} tool changes</source>
        <translation>{} changements d’outil</translation>
    </message>
    <message>
        <source>{} spindle start</source>
        <translation>{} démarrage de la broche</translation>
    </message>
    <message>
        <source>{} spindle starts</source>
        <translation>{} démarrages de la broche</translation>
    </message>
    <message>
        <source>{} program stop (M0, M1)</source>
        <translation>{} arrêt programme (M0, M1)</translation>
    </message>
    <message>
        <source>{} program stops (M0, M1)</source>
        <translation>{} arrêts programme (M0, M1)</translation>
    </message>
    <message>
        <source>{} move to or from a machine position</source>
        <translation>{} déplacement vers ou depuis une position machine</translation>
    </message>
    <message>
        <source>{} moves to or from machine positions</source>
        <translation>{} déplacements vers ou depuis des positions machine</translation>
    </message>
    <message>
        <source>{} turn of rotary axes for a tilted plane</source>
        <translation>{} rotation d’axes rotatifs pour un plan incliné</translation>
    </message>
    <message>
        <source>{} turns of rotary axes for tilted planes</source>
        <translation>{} rotations d’axes rotatifs pour des plans inclinés</translation>
    </message>
    <message>
        <source>{} possible delay by X, Y and Z that follow rotary axes (tool length or part zero unknown)</source>
        <translation>{} retard possible par X, Y et Z qui suivent les axes rotatifs (longueur d’outil ou origine de la pièce inconnue)</translation>
    </message>
    <message>
        <source>{} possible delays by X, Y and Z that follow rotary axes (tool length or part zero unknown)</source>
        <translation>{} retards possibles par X, Y et Z qui suivent les axes rotatifs (longueur d’outil ou origine de la pièce inconnue)</translation>
    </message>
    <message>
        <source>motion of {}</source>
        <translation>mouvement de {}</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} à {}</translation>
    </message>
    <message>
        <source>{}, {}</source>
        <translation>{}, {}</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} et {} de plus</translation>
    </message>
    <message>
        <source>1 line of the program is refused by the control and not run (line {}).</source>
        <translation>1 ligne du programme est refusée par la commande et n’est pas exécutée (ligne {}).</translation>
    </message>
    <message>
        <source>{} lines of the program are refused by the control and not run (lines {}).</source>
        <translation>{} lignes du programme sont refusées par la commande et ne sont pas exécutées (lignes {}).</translation>
    </message>
    <message>
        <source>{}, line {}: {}</source>
        <translation>{}, ligne {}&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}; before that, {} ({})</source>
        <translation>{}&#xa0;; avant cela, {} ({})</translation>
    </message>
    <message>
        <source>{}; {}</source>
        <translation>{}&#xa0;; {}</translation>
    </message>
    <message>
        <source>{}; the program is not simulated: check its loops, raise the limit (--repeat-limit), or simulate the part that was read (--simulate-cut-off)</source>
        <translation>{}&#xa0;; le programme n’est pas simulé&#xa0;: vérifiez ses boucles, augmentez la limite (--repeat-limit), ou simulez la partie lue (--simulate-cut-off)</translation>
    </message>
    <message>
        <source>The drive of axis {0} is poorly damped: it overshoots a step by {1:.0f} %; a smaller {0}.kv or {0}.velocity_lag damps it better.</source>
        <translation>L’entraînement de l’axe {0} est mal amorti&#xa0;: il dépasse un échelon de {1}&#xa0;%&#xa0;; un {0}.kv ou un {0}.velocity_lag plus petit l’amortit mieux.</translation>
    </message>
    <message>
        <source>No drive is given for {}: followed exactly.</source>
        <translation>Aucun entraînement n’est donné pour {}&#xa0;: suivi exact.</translation>
    </message>
    <message>
        <source>Rotary axes: line {}: {}.</source>
        <translation>Axes rotatifs&#xa0;: ligne {}&#xa0;: {}.</translation>
    </message>
    <message>
        <source>Rotary axes: line {}: {}. {} more.</source>
        <translation>Axes rotatifs&#xa0;: ligne {}&#xa0;: {}. {} de plus.</translation>
    </message>
    <message>
        <source>Positions of rotary axes that the machine does not reach: line {}: {}.</source>
        <translation>Positions d’axes rotatifs que la machine n’atteint pas&#xa0;: ligne {}&#xa0;: {}.</translation>
    </message>
    <message>
        <source>Positions of rotary axes that the machine does not reach: line {}: {}. {} more.</source>
        <translation>Positions d’axes rotatifs que la machine n’atteint pas&#xa0;: ligne {}&#xa0;: {}. {} de plus.</translation>
    </message>
    <message>
        <source>The program was read with work offsets other than those of the machine ({}).</source>
        <translation>Le programme a été lu avec d’autres décalages d’origine que ceux de la machine ({}).</translation>
    </message>
    <message>
        <source>the sweeps need more than {} runs; use fewer values</source>
        <translation>les balayages demandent plus de {} simulations&#xa0;; prenez moins de valeurs</translation>
    </message>
    <message>
        <source>sweep &apos;{}&apos;: {}; write KEY=FROM:TO:logN, KEY=FROM:TO:linN or &quot;KEY=A;B;C&quot;, such as tolerance=0.005:0.1:log12</source>
        <translation>balayage &apos;{}&apos;&#xa0;: {}&#xa0;; écrivez KEY=FROM:TO:logN, KEY=FROM:TO:linN ou &quot;KEY=A;B;C&quot;, par exemple tolerance=0.005:0.1:log12</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number, and only numbers can be swept</source>
        <translation>&apos;{}&apos; n’est pas un nombre, et seuls des nombres peuvent être balayés</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has a comma: {}</source>
        <translation>&apos;{}&apos; contient une virgule&#xa0;: {}</translation>
    </message>
    <message>
        <source>a range has three parts, not {}</source>
        <translation>une plage a trois parties, et non {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is neither logN nor linN</source>
        <translation>&apos;{}&apos; n’est ni logN ni linN</translation>
    </message>
    <message>
        <source>{} values; there must be a whole number from 2 to {}</source>
        <translation>{} valeurs&#xa0;; il faut un nombre entier de 2 à {}</translation>
    </message>
    <message>
        <source>from {} to {} is not a range</source>
        <translation>de {} à {}, ce n’est pas une plage</translation>
    </message>
    <message>
        <source>equal ratios need ends above 0, not {}</source>
        <translation>des rapports égaux demandent des bornes supérieures à 0, et non {}</translation>
    </message>
    <message>
        <source>{} values; there must be 2 to {}</source>
        <translation>{} valeurs&#xa0;; il en faut de 2 à {}</translation>
    </message>
    <message>
        <source>{} limits {:.3g} s of the cycle time ({:.2g} %), but the recordings that the machine was identified from do not determine it.</source>
        <translation>{} limite {} s du temps de cycle ({} %), mais les enregistrements dont la machine a été identifiée ne déterminent pas cette valeur.</translation>
    </message>
    <message>
        <source>also in line {}</source>
        <translation>aussi à la ligne {}</translation>
    </message>
    <message>
        <source>also in lines {}</source>
        <translation>aussi aux lignes {}</translation>
    </message>
    <message>
        <source>{} more up to line {}</source>
        <translation>{} autres jusqu’à la ligne {}</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} et {}</translation>
    </message>
    <message>
        <source>a number has one decimal separator and no thousands separators; write {}</source>
        <translation>un nombre a un seul séparateur décimal et pas de séparateur de milliers&#xa0;; écrivez {}</translation>
    </message>
    <message>
        <source>the comma could be a decimal or a thousands separator; write {} or {}</source>
        <translation>la virgule pourrait être un séparateur décimal ou de milliers&#xa0;; écrivez {} ou {}</translation>
    </message>
    <message>
        <source>a comma does not separate values here; write &quot;{}&quot; in quotes</source>
        <translation>une virgule ne sépare pas de valeurs ici&#xa0;; écrivez &quot;{}&quot; entre guillemets</translation>
    </message>
    <message>
        <source>the comma could be a decimal separator or separate values; write {} for one value, &quot;{}&quot; in quotes for several</source>
        <translation>la virgule peut être un signe décimal ou séparer des valeurs&#xa0;; écrivez {} pour une valeur, &quot;{}&quot; entre guillemets pour plusieurs</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no number of model &apos;{}&apos; that can be fitted; {}</source>
        <translation>&apos;{}&apos; n’est pas un nombre du modèle &apos;{}&apos; qui puisse être ajusté&#xa0;; {}</translation>
    </message>
    <message>
        <source>known: {}</source>
        <translation>sont connus&#xa0;: {}</translation>
    </message>
    <message>
        <source>did you mean &apos;{}&apos;?</source>
        <translation>vouliez-vous dire &apos;{}&apos; ?</translation>
    </message>
    <message>
        <source>{} = {} {} is out of bounds; it must be from {} to {} {}</source>
        <translation>{} = {} {} hors limites&#xa0;; il faut de {} à {} {}</translation>
    </message>
    <message>
        <source>there is no test program for dialect &apos;{}&apos;; there is one for iso, fanuc, linuxcnc, grbl, sinumerik and heidenhain</source>
        <translation>il n’y a pas de programme d’essai pour le dialecte &apos;{}&apos;&#xa0;; il y en a un pour iso, fanuc, linuxcnc, grbl, sinumerik et heidenhain</translation>
    </message>
    <message>
        <source>{} is found from set and actual positions of {}; no trace has both: record the actual position too, and name it if need be, as --columns actual_{}=5:mm</source>
        <translation>{} se détermine par les positions de consigne et réelles de {}&#xa0;; aucune trace n’a les deux&#xa0;: enregistrez aussi la position réelle, et nommez-la au besoin, comme --columns actual_{}=5:mm</translation>
    </message>
    <message>
        <source>{}: the sections take {:.4g} times what machine &apos;{}&apos; takes in the simulation; {}</source>
        <translation>{} : les sections prennent {} fois le temps de la machine « {} » dans la simulation ; {}</translation>
    </message>
    <message>
        <source>{}:{}: not a table of section times; the first row must have the titles, such as section,seconds</source>
        <translation>{}:{}&#xa0;: ce n’est pas un tableau de temps de sections&#xa0;; la première ligne doit porter les titres, par exemple section,seconds</translation>
    </message>
    <message>
        <source>{}:{}: &apos;{}&apos; is not a section and its time; a row is like 12,1.234, with a time above 0 and below {:g} s</source>
        <translation>{}:{}&#xa0;: «&#xa0;{}&#xa0;» n’est pas une section et son temps&#xa0;; une ligne est de la forme 12,1.234, avec un temps supérieur à 0 et inférieur à {}&#xa0;s</translation>
    </message>
    <message>
        <source>{}:{}: section {} has a time in line {} already; keep one of the two</source>
        <translation>{}:{}&#xa0;: la section {} a déjà un temps à la ligne {}&#xa0;; garder l’un des deux</translation>
    </message>
    <message>
        <source>{}: section times given: {}; at least {} can tell something</source>
        <translation>{}&#xa0;: temps de sections donnés&#xa0;: {}&#xa0;; il en faut au moins {} pour révéler quelque chose</translation>
    </message>
    <message>
        <source>{}:{}: {} has no section &apos;{}&apos;; a section is marked by the comments SECTION 12 BEGINS and SECTION 12 ENDS, or is given by its lines, as 40-55</source>
        <translation>{}:{}&#xa0;: {} n’a pas de section «&#xa0;{}&#xa0;»&#xa0;; une section est marquée par les commentaires SECTION 12 BEGINS et SECTION 12 ENDS, ou donnée par ses lignes, par exemple 40-55</translation>
    </message>
    <message>
        <source>{}: the trace does not belong to its program as it is: {}; {}</source>
        <translation>{}&#xa0;: telle quelle, la trace n’est pas celle de son programme&#xa0;: {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>{}: the trace does not belong to its program: {:.1f} % of its way runs along the path within {:.3g} mm, and along {:.1f} % of it; give the program that was recorded, with the zero point it ran with</source>
        <translation>{}&#xa0;: la trace n’est pas celle de son programme&#xa0;: {}&#xa0;% de son parcours suit le trajet à moins de {}&#xa0;mm, et sur {}&#xa0;% de celui-ci&#xa0;; donner le programme enregistré, avec l’origine avec laquelle il a tourné</translation>
    </message>
    <message>
        <source>{}: no limits can be found from this trace: {}; {}</source>
        <translation>{}&#xa0;: aucune limite ne peut être trouvée d’après cette trace&#xa0;: {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>{}: the trace holds too little of its program to find anything from it</source>
        <translation>{}&#xa0;: la trace contient trop peu de son programme pour en tirer quelque chose</translation>
    </message>
    <message>
        <source>ae_mm {:.6g} is larger than diameter_mm {:.6g}; a tool is engaged over its diameter at most: lower ae_mm, {:.6g} is a full slot</source>
        <translation>ae_mm {} dépasse diameter_mm {}&#xa0;; un outil est engagé au plus sur son diamètre&#xa0;: réduisez ae_mm, {} est un rainurage en pleine matière</translation>
    </message>
    <message>
        <source>lines {}-{} is no range; write FIRST-LAST, counted from 1</source>
        <translation>lignes {}-{}&#xa0;: ce n’est pas une plage&#xa0;; écrivez PREMIÈRE-DERNIÈRE, comptées à partir de 1</translation>
    </message>
    <message>
        <source>min_chip_um {:.6g} is not below max_chip_um {:.6g}; every chip would be out of bounds</source>
        <translation>min_chip_um {} n’est pas inférieur à max_chip_um {}&#xa0;; tout copeau serait hors limites</translation>
    </message>
    <message>
        <source>tool {}</source>
        <translation>outil {}</translation>
    </message>
    <message>
        <source>all tools, lines {}</source>
        <translation>tous les outils, lignes {}</translation>
    </message>
    <message>
        <source>tool {}, lines {}</source>
        <translation>outil {}, lignes {}</translation>
    </message>
    <message>
        <source>{} in {} must be a number</source>
        <translation>{} dans {} doit être un nombre</translation>
    </message>
    <message>
        <source>milling &apos;{}&apos; is not known; write &quot;up&quot; (conventional) or &quot;down&quot; (climb)</source>
        <translation>fraisage &apos;{}&apos; inconnu&#xa0;; écrivez &quot;up&quot; (en opposition) ou &quot;down&quot; (en avalant)</translation>
    </message>
    <message>
        <source>law &apos;{}&apos; is not known; write &quot;linear-edge&quot; or &quot;kienzle&quot;</source>
        <translation>loi &apos;{}&apos; inconnue&#xa0;; écrivez &quot;linear-edge&quot; ou &quot;kienzle&quot;</translation>
    </message>
    <message>
        <source>{} has no tangential cutting force; {} must be above 0</source>
        <translation>{} n’a pas d’effort de coupe tangentiel&#xa0;; {} doit être supérieur à 0</translation>
    </message>
    <message>
        <source>material &apos;{}&apos; is given twice; remove one or give it another id</source>
        <translation>la matière &apos;{}&apos; est donnée deux fois&#xa0;; supprimez-en une ou donnez-lui un autre identifiant</translation>
    </message>
    <message>
        <source>load files of version {:.0f} are not known; this program reads version {:.0f}</source>
        <translation>les fichiers de charge de la version {} ne sont pas connus&#xa0;; ce programme lit la version {}</translation>
    </message>
    <message>
        <source>operations {} ({}) and {} ({}) apply to the same motions; remove one, or give each its own tool or lines</source>
        <translation>les opérations {} ({}) et {} ({}) s’appliquent aux mêmes déplacements&#xa0;; supprimez-en une, ou donnez à chacune son outil ou ses lignes</translation>
    </message>
    <message>
        <source>the load file has an operation for tool {}, but the program changes to no tool; omit &apos;tool&apos;, so that the operation applies to all motions</source>
        <translation>le fichier de charge a une opération pour l’outil {}, mais le programme n’appelle aucun outil&#xa0;; supprimez &apos;tool&apos;, pour que l’opération s’applique à tous les déplacements</translation>
    </message>
    <message>
        <source>the load file has an operation for tool {}, which the program never changes to; {}</source>
        <translation>le fichier de charge a une opération pour l’outil {}, que le programme n’appelle jamais&#xa0;; {}</translation>
    </message>
    <message>
        <source>its tools are {}</source>
        <translation>ses outils sont {}</translation>
    </message>
    <message>
        <source>did you mean tool {}?</source>
        <translation>vouliez-vous dire l’outil {}&#xa0;?</translation>
    </message>
    <message>
        <source>the load file has an operation for lines {}-{}, but the program has {} lines; correct the range</source>
        <translation>le fichier de charge a une opération pour les lignes {}-{}, mais le programme compte {} lignes&#xa0;; corrigez la plage</translation>
    </message>
    <message>
        <source>operation of {}: {}</source>
        <translation>opération de {}&#xa0;: {}</translation>
    </message>
    <message>
        <source>material &apos;{}&apos; is not known; {}, or add a [[material]] with its coefficients</source>
        <translation>la matière &apos;{}&apos; n’est pas connue&#xa0;; {}, ou ajoutez un [[material]] avec ses coefficients</translation>
    </message>
    <message>
        <source>use one such as &apos;{}&apos;</source>
        <translation>utilisez-en une comme &apos;{}&apos;</translation>
    </message>
    <message>
        <source>axis {} has values of a drive but no position gain; give {}.kv in 1/s, or remove the others</source>
        <translation>l’axe {} a des valeurs d’entraînement mais pas de gain de position&#xa0;; donnez {}.kv en 1/s, ou supprimez les autres</translation>
    </message>
    <message>
        <source>axis {} has a friction spike but no time in which it decays; give {}.friction_time in ms</source>
        <translation>l’axe {} a un pic de frottement mais pas de temps de décroissance&#xa0;; donnez {}.friction_time en ms</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos; in {}; {}</source>
        <translation>clé &apos;{}&apos; inconnue dans {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>key &apos;{}&apos; is missing in {}</source>
        <translation>il manque la clé &apos;{}&apos; dans {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; in {} must be a table</source>
        <translation>&apos;{}&apos; dans {} doit être une table</translation>
    </message>
    <message>
        <source>&apos;{}&apos; in {} must be a text in quotes</source>
        <translation>&apos;{}&apos; dans {} doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>not valid TOML: {}</source>
        <translation>TOML non valide&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a folder; give a {}</source>
        <translation>&apos;{}&apos; est un dossier&#xa0;; il faut un fichier&#xa0;: {}</translation>
    </message>
    <message>
        <source>cannot read {} &apos;{}&apos;: {}</source>
        <translation>&apos;{1}&apos; ne peut pas être lu ({0})&#xa0;: {2}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is larger than {} MiB and cannot be a {}</source>
        <translation>&apos;{}&apos; dépasse {} Mio et ne peut pas être ce qui est attendu&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a parameter; it is skipped</source>
        <translation>&apos;{}&apos; n’est pas un paramètre&#xa0;; il est ignoré</translation>
    </message>
    <message>
        <source>{} ({}) is not modelled</source>
        <translation>{} ({}) n’est pas modélisé</translation>
    </message>
    <message>
        <source>there is no linear axis {}; its limits are assumed</source>
        <translation>il n’y a pas d’axe linéaire {}&#xa0;; ses limites sont supposées</translation>
    </message>
    <message>
        <source>{} is the cutting feed without look-ahead control; that with it, {}, is used</source>
        <translation>{} est l’avance de coupe sans commande anticipée&#xa0;; celle avec elle, {}, est utilisée</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a setting; it is skipped</source>
        <translation>&apos;{}&apos; n’est pas un réglage&#xa0;; il est ignoré</translation>
    </message>
    <message>
        <source>${} = {}, but {} in {}; {} is used</source>
        <translation>${} = {}, mais {} dans {}&#xa0;; {} est utilisé</translation>
    </message>
    <message>
        <source>{} is simulated as grbl with its values; what it does otherwise is not modelled</source>
        <translation>{} est simulé comme grbl avec ses valeurs&#xa0;; ce qu’il fait autrement n’est pas modélisé</translation>
    </message>
    <message>
        <source>the acceleration along the path, {} m/s2, is not modelled: those of the axes hold</source>
        <translation>l’accélération le long de la trajectoire, {} m/s², n’est pas modélisée&#xa0;: celles des axes valent</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a machine parameter; it is skipped</source>
        <translation>&apos;{}&apos; n’est pas un paramètre machine&#xa0;; il est ignoré</translation>
    </message>
    <message>
        <source>{} must be above {}: Klipper does not start with it</source>
        <translation>{} doit être supérieur à {}&#xa0;: Klipper ne démarre pas ainsi</translation>
    </message>
    <message>
        <source>{} exceeds {} = {} ({}): Klipper does not start with it</source>
        <translation>{} dépasse {} = {} ({})&#xa0;: Klipper ne démarre pas ainsi</translation>
    </message>
    <message>
        <source>lower {}</source>
        <translation>réduisez {}</translation>
    </message>
    <message>
        <source>kinematics {} are not modelled: limits hold along the path, and those of Z alone</source>
        <translation>la cinématique {} n’est pas modélisée&#xa0;: les limites valent le long de la trajectoire, et celles de Z seules</translation>
    </message>
    <message>
        <source>[printer] {} is not used here; skipped</source>
        <translation>[printer] {} n’est pas utilisé ici&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>LINEAR_UNITS = {} is not a unit; mm is assumed</source>
        <translation>LINEAR_UNITS = {} n’est pas une unité&#xa0;; le mm est supposé</translation>
    </message>
    <message>
        <source>kinematics {} is not modelled: X, Y and Z are treated as axes of their own</source>
        <translation>la cinématique {} n’est pas modélisée&#xa0;: X, Y et Z sont traités comme des axes indépendants</translation>
    </message>
    <message>
        <source>axis {} is not part of the simulation; skipped</source>
        <translation>l’axe {} ne fait pas partie de la simulation&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>[{}] gives no {}; that of [{}] is assumed</source>
        <translation>[{}] ne donne pas {}&#xa0;; celui de [{}] est supposé</translation>
    </message>
    <message>
        <source>write {} into [{}]: LinuxCNC does not take it from the joint</source>
        <translation>écrivez {} dans [{}]&#xa0;: LinuxCNC ne le prend pas de l’articulation (joint)</translation>
    </message>
    <message>
        <source>{} of axis {} is missing; it is assumed</source>
        <translation>{} de l’axe {} manque&#xa0;; il est supposé</translation>
    </message>
    <message>
        <source>write {} into [{}]</source>
        <translation>écrivez {} dans [{}]</translation>
    </message>
    <message>
        <source>[{}] {} = {} exceeds [{}] {} = {} ({}); the planner uses {}</source>
        <translation>[{}] {} = {} dépasse [{}] {} = {} ({})&#xa0;; le planificateur utilise {}</translation>
    </message>
    <message>
        <source>[TRAJ] {} = {} is not modelled; the model computes with {}</source>
        <translation>[TRAJ] {} = {} n’est pas modélisé&#xa0;; le modèle calcule avec {}</translation>
    </message>
    <message>
        <source>P of G64 in the start-up code has no effect on blends in LinuxCNC 2.9; P{} is used for joining blocks alone</source>
        <translation>P de G64 dans le code de démarrage n’a pas d’effet sur les raccords dans LinuxCNC 2.9&#xa0;; P{} ne sert qu’à réunir des blocs</translation>
    </message>
    <message>
        <source>[{}] {} is not known; skipped</source>
        <translation>[{}] {} n’est pas connu&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>the offsets of {} are not in the INI file; 0 is assumed</source>
        <translation>les décalages de {} ne sont pas dans le fichier INI&#xa0;; 0 est supposé</translation>
    </message>
    <message>
        <source>{} of axis {} cannot be used: {}</source>
        <translation>{} de l’axe {} n’est pas utilisable&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} cannot be used: {}</source>
        <translation>{} n’est pas utilisable&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a number</source>
        <translation>{}&#xa0;: &apos;{}&apos; n’est pas un nombre</translation>
    </message>
    <message>
        <source>not used: {}</source>
        <translation>non utilisé&#xa0;: {}</translation>
    </message>
    <message>
        <source>not used: {} and {} more</source>
        <translation>non utilisé&#xa0;: {} et {} de plus</translation>
    </message>
    <message>
        <source>{} more notes are not listed</source>
        <translation>{} remarques de plus ne sont pas affichées</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not the configuration of a control that can be imported; known: {}</source>
        <translation>&apos;{}&apos; n’est pas la configuration d’une commande qui puisse être importée&#xa0;; connues&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a value; it is skipped</source>
        <translation>{}&#xa0;: &apos;{}&apos; n’est pas une valeur&#xa0;; elle est ignorée</translation>
    </message>
    <message>
        <source>{}, but {} in {}; {} is used</source>
        <translation>{}, mais {} dans {}&#xa0;; {} est utilisé</translation>
    </message>
    <message>
        <source>{} exceeds {} ({}); the lower one is used</source>
        <translation>{} dépasse {} ({})&#xa0;; la plus petite est utilisée</translation>
    </message>
    <message>
        <source>acceleration of travel moves {} is not modelled: they have that of the others</source>
        <translation>l’accélération des déplacements à vide {} n’est pas modélisée&#xa0;: ils ont celle des autres</translation>
    </message>
    <message>
        <source>there is no model of {}: Klipper&apos;s runs its limits; its look-ahead has no end, while that of the firmware has some 16 blocks, so that short blocks may take longer there</source>
        <translation>il n’y a pas de modèle de {}&#xa0;: celui de Klipper applique ses limites&#xa0;; son anticipation est sans fin, alors que celle du micrologiciel compte quelque 16 blocs, des blocs courts peuvent donc y prendre plus de temps</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is neither a section nor a value; skipped</source>
        <translation>&apos;{}&apos; n’est ni une section ni une valeur&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>[{}] {} = {}, but {} in {}; {} is used</source>
        <translation>[{}] {} = {}, mais {} dans {}&#xa0;; {} est utilisé</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be included: {}</source>
        <translation>&apos;{}&apos; ne peut pas être inclus&#xa0;: {}</translation>
    </message>
    <message>
        <source>more than {} files deep</source>
        <translation>plus de {} fichiers imbriqués</translation>
    </message>
    <message>
        <source>more than {} files</source>
        <translation>plus de {} fichiers</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no machine datum; skipped</source>
        <translation>&apos;{}&apos; n’est pas une donnée machine&#xa0;; ignoré</translation>
    </message>
    <message>
        <source>machine axis {} would be {} but is a rotary axis; its limits are assumed</source>
        <translation>l’axe machine {} serait {} mais est un axe rotatif&#xa0;; ses limites sont supposées</translation>
    </message>
    <message>
        <source>{} holds with {}; the value of DYNNORM, {}, is used</source>
        <translation>{} vaut avec {}&#xa0;; la valeur de DYNNORM, {}, est utilisée</translation>
    </message>
    <message>
        <source>axis {} is a rotary axis, and the file does not say where it is; add [kinematics] with its chain, and {} with direction and point</source>
        <translation>l’axe {} est un axe rotatif, et le fichier ne dit pas où il se trouve&#xa0;; ajoutez [kinematics] avec sa chaîne, et {} avec direction et point</translation>
    </message>
    <message>
        <source>{} has no limits; add [axes.{}]</source>
        <translation>{} n’a pas de limites&#xa0;; ajoutez [axes.{}]</translation>
    </message>
    <message>
        <source>unknown axis &apos;{}&apos;; the axes are {}</source>
        <translation>axe &apos;{}&apos; inconnu&#xa0;; les axes sont {}</translation>
    </message>
    <message>
        <source>unknown limit &apos;{}&apos; of axis {}; {}</source>
        <translation>limite &apos;{}&apos; inconnue de l’axe {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>the limits are {}</source>
        <translation>les limites sont {}</translation>
    </message>
    <message>
        <source>machine &apos;{}&apos;: {}</source>
        <translation>machine &apos;{}&apos;&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} is not a work offset; write it as programs name it, such as G55, &quot;G54.1 P3&quot; or G505</source>
        <translation>{} n’est pas un décalage d’origine&#xa0;; écrivez-le comme les programmes le nomment, par exemple G55, &quot;G54.1 P3&quot; ou G505</translation>
    </message>
    <message>
        <source>{} is given twice; remove one</source>
        <translation>{} est donné deux fois&#xa0;; supprimez-en un</translation>
    </message>
    <message>
        <source>cannot read machine folder &apos;{}&apos;: {}</source>
        <translation>le dossier de machines &apos;{}&apos; ne peut pas être lu&#xa0;: {}</translation>
    </message>
    <message>
        <source>unknown machine &apos;{}&apos;: neither a machine id nor a file; {}</source>
        <translation>machine &apos;{}&apos; inconnue&#xa0;: ni identifiant de machine, ni fichier&#xa0;; {}</translation>
    </message>
    <message>
        <source>ids: {}</source>
        <translation>identifiants&#xa0;: {}</translation>
    </message>
    <message>
        <source>the chain &apos;{}&apos; {}; name X, Y, Z and the rotary axes once each from the part to the tool, with the word frame between those that carry the part and those that carry the tool, as in &quot;C A Y frame X Z&quot;</source>
        <translation>la chaîne &apos;{}&apos; {}&#xa0;; nommez X, Y, Z et les axes rotatifs une fois chacun, de la pièce à l’outil, avec le mot frame entre ceux qui portent la pièce et ceux qui portent l’outil, comme dans &quot;C A Y frame X Z&quot;</translation>
    </message>
    <message>
        <source>has the word frame twice</source>
        <translation>contient deux fois le mot frame</translation>
    </message>
    <message>
        <source>has &apos;{}&apos;, which is no axis of this machine</source>
        <translation>contient &apos;{}&apos;, qui n’est pas un axe de cette machine</translation>
    </message>
    <message>
        <source>has {} twice</source>
        <translation>contient deux fois {}</translation>
    </message>
    <message>
        <source>the travel of axis {} is empty, from {:g} to {:g} degrees</source>
        <translation>la course de l’axe {} est vide, de {} à {} degrés</translation>
    </message>
    <message>
        <source>lacks the word frame</source>
        <translation>n’a pas le mot frame</translation>
    </message>
    <message>
        <source>lacks axis {}</source>
        <translation>n’a pas l’axe {}</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <source>at most {}</source>
        <translation>d’au plus {}</translation>
    </message>
    <message>
        <source>finite</source>
        <translation>finie</translation>
    </message>
    <message>
        <source>0, or at least {}</source>
        <translation>de 0, ou d’au moins {}</translation>
    </message>
    <message>
        <source>at least {}</source>
        <translation>d’au moins {}</translation>
    </message>
    <message>
        <source>above {}</source>
        <translation>supérieure à {}</translation>
    </message>
    <message>
        <source>{} and at most {}</source>
        <translation>{} et d’au plus {}</translation>
    </message>
    <message>
        <source>a whole number {}</source>
        <translation>entière {}</translation>
    </message>
    <message>
        <source>setting &apos;{}&apos; has no value</source>
        <translation>le réglage &apos;{}&apos; est sans valeur</translation>
    </message>
    <message>
        <source>setting &apos;{}&apos; is the text &apos;{}&apos;, not a number</source>
        <translation>le réglage &apos;{}&apos; est le texte &apos;{}&apos;, et non un nombre</translation>
    </message>
    <message>
        <source>setting &apos;{}&apos; is the number {}, not a text</source>
        <translation>le réglage &apos;{}&apos; est le nombre {}, et non un texte</translation>
    </message>
    <message>
        <source>{} = &apos;{}&apos; is not a number; it must be {}</source>
        <translation>{} = &apos;{}&apos; n’est pas un nombre&#xa0;; il doit être {}</translation>
    </message>
    <message>
        <source>{} = &apos;{}&apos;: {}</source>
        <translation>{} = &apos;{}&apos;&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} = &apos;{}&apos; is not a valid choice; it must be one of: {}</source>
        <translation>{} = &apos;{}&apos; n’est pas un choix valable&#xa0;; il faut l’un de&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} = &apos;{}&apos; is text; it must be a number {}</source>
        <translation>{} = &apos;{}&apos; est un texte&#xa0;; ce doit être un nombre&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} = {} is out of bounds; it must be {}</source>
        <translation>{} = {} est hors des bornes&#xa0;; il faut une valeur {}</translation>
    </message>
    <message>
        <source>{} must have one of source = &quot;paper, table&quot; and assumed = &quot;reason&quot;</source>
        <translation>{} doit avoir soit source = &quot;paper, table&quot;, soit assumed = &quot;reason&quot;</translation>
    </message>
    <message>
        <source>{} needs a source: write {{ value = ..., source = &quot;paper, table&quot; }} or {{ value = ..., assumed = &quot;reason&quot; }}</source>
        <translation>{} demande une source&#xa0;: écrivez {{ value = ..., source = &quot;paper, table&quot; }} ou {{ value = ..., assumed = &quot;reason&quot; }}</translation>
    </message>
    <message>
        <source>value of {} must be a number</source>
        <translation>la valeur de {} doit être un nombre</translation>
    </message>
    <message>
        <source>value of {} must be a number or text</source>
        <translation>la valeur de {} doit être un nombre ou un texte</translation>
    </message>
    <message>
        <source>{} of {} must be a number</source>
        <translation>{} de {} doit être un nombre</translation>
    </message>
    <message>
        <source>machine &apos;{}&apos;: axis {} moves in this program, but one of its limits is {}; every limit of an axis that moves must be above 0</source>
        <translation>machine &apos;{}&apos;&#xa0;: l’axe {} se déplace dans ce programme, mais l’une de ses limites vaut {}&#xa0;; toute limite d’un axe qui se déplace doit être supérieure à 0</translation>
    </message>
    <message>
        <source>unknown model &apos;{}&apos;; known models: {}</source>
        <translation>modèle &apos;{}&apos; inconnu&#xa0;; modèles connus&#xa0;: {}</translation>
    </message>
    <message>
        <source>unknown model &apos;{}&apos;; did you mean &apos;{}&apos;? known models: {}</source>
        <translation>modèle &apos;{}&apos; inconnu&#xa0;; vouliez-vous dire &apos;{}&apos;&#xa0;? modèles connus&#xa0;: {}</translation>
    </message>
    <message>
        <source>radius {} mm at its start, {} mm at its end</source>
        <translation>rayon de {} mm au début, de {} mm à la fin</translation>
    </message>
    <message>
        <source>grbl rejects the line (error {}: {}); it is not run</source>
        <translation>grbl rejette la ligne (erreur {}&#xa0;: {})&#xa0;; elle n’est pas exécutée</translation>
    </message>
    <message>
        <source>grbl rejects the line (error {}: {}: {}); it is not run</source>
        <translation>grbl rejette la ligne (erreur {}&#xa0;: {}&#xa0;: {})&#xa0;; elle n’est pas exécutée</translation>
    </message>
    <message>
        <source>{} times the limit</source>
        <translation>{} fois la limite</translation>
    </message>
    <message>
        <source>{} of every axis: along the path the change of the acceleration (v&apos;&apos;) and the part due to curvature (v^3 k^2) each stay within {}, together within {} times the limit; across the path (3 v v&apos; k) it is not bounded</source>
        <translation>{} de chaque axe&#xa0;: le long de la trajectoire, la variation de l’accélération (v&apos;&apos;) et la part due à la courbure (v^3 k^2) restent chacune au plus à {}, ensemble au plus à {} fois la limite&#xa0;; normalement à la trajectoire (3 v v&apos; k), sans borne</translation>
    </message>
    <message>
        <source>{} of every axis: along and across the path it stays within {} each, together within {} times the limit</source>
        <translation>{} de chaque axe&#xa0;: le long de la trajectoire et normalement à elle, au plus {} chacune, ensemble au plus {} fois la limite</translation>
    </message>
    <message>
        <source>{} are not bounded</source>
        <translation>{} sans borne</translation>
    </message>
    <message>
        <source>{} is not bounded</source>
        <translation>{} sans borne</translation>
    </message>
    <message>
        <source>{} of every axis are kept</source>
        <translation>{} de chaque axe dans leurs limites</translation>
    </message>
    <message>
        <source>{} of every axis is kept</source>
        <translation>{} de chaque axe dans sa limite</translation>
    </message>
    <message>
        <source>{} of every axis stay within {} times the limit</source>
        <translation>{} de chaque axe au plus à {} fois la limite</translation>
    </message>
    <message>
        <source>{} of every axis stays within {} times the limit</source>
        <translation>{} de chaque axe au plus à {} fois la limite</translation>
    </message>
    <message>
        <source>Never faster than {}; rapids run at the maximum velocity of the control.</source>
        <translation>Jamais plus vite que {}&#xa0;; les rapides vont à la vitesse maximale de la commande.</translation>
    </message>
    <message>
        <source>Never faster than {}; rapids never faster than the axes allow.</source>
        <translation>Jamais plus vite que {}&#xa0;; les rapides jamais plus vite que les axes ne le permettent.</translation>
    </message>
    <message>
        <source>Never faster than {} times {}.</source>
        <translation>Jamais plus vite que {} fois {}.</translation>
    </message>
    <message>
        <source>Every programmed corner lies within {} times the contour tolerance of the path; tangent transitions between blocks are passed exactly.</source>
        <translation>Chaque angle programmé est à moins de {} fois la tolérance de contour de la trajectoire&#xa0;; les transitions tangentes entre blocs sont suivies exactement.</translation>
    </message>
    <message>
        <source>Every programmed corner lies within {} times the contour tolerance of the path.</source>
        <translation>Chaque angle programmé est à moins de {} fois la tolérance de contour de la trajectoire.</translation>
    </message>
    <message>
        <source>Where rotary axes turn in rapids, every axis of the machine stays within {} times its velocity.</source>
        <translation>Là où des axes rotatifs tournent en rapide, chaque axe de la machine reste en deçà de {} fois sa vitesse maximale.</translation>
    </message>
    <message>
        <source>Where rotary axes turn, every axis of the machine stays within {} times its velocity.</source>
        <translation>Là où des axes rotatifs tournent, chaque axe de la machine reste en deçà de {} fois sa vitesse maximale.</translation>
    </message>
    <message>
        <source>Full stops {}.</source>
        <translation>Arrêts complets {}.</translation>
    </message>
    <message>
        <source>On lines: {}.</source>
        <translation>Sur les droites&#xa0;: {}.</translation>
    </message>
    <message>
        <source>On arcs: {}.</source>
        <translation>Sur les arcs&#xa0;: {}.</translation>
    </message>
    <message>
        <source>On corner blends: {}.</source>
        <translation>Sur les raccords d’angle&#xa0;: {}.</translation>
    </message>
    <message>
        <source>On smooth curves: {}.</source>
        <translation>Sur les courbes lissées&#xa0;: {}.</translation>
    </message>
    <message>
        <source>invalid value of {}</source>
        <translation>valeur de {} non valide</translation>
    </message>
    <message>
        <source>Klipper rejects the line ({}); it is not run</source>
        <translation>Klipper rejette la ligne ({})&#xa0;; elle n’est pas exécutée</translation>
    </message>
    <message>
        <source>unknown command {}</source>
        <translation>commande {} inconnue</translation>
    </message>
    <message>
        <source>{} has no number</source>
        <translation>{} est sans nombre</translation>
    </message>
    <message>
        <source>setting path: the path of ward needs more than {} curves to be approximated within {} mm, up to line {}; choose the path of another model</source>
        <translation>réglage path&#xa0;: la trajectoire de ward demande plus de {} courbes pour être approchée à {} mm près, jusqu’à la ligne {}&#xa0;; choisissez la trajectoire d’un autre modèle</translation>
    </message>
    <message>
        <source>{} is missing or zero</source>
        <translation>{} manque ou est nul</translation>
    </message>
    <message>
        <source>its radius R of {:.3f} mm on the other side is not larger than the tool radius, {:.3f} mm</source>
        <translation>son rayon R de {} mm de l’autre côté n’est pas plus grand que le rayon de l’outil, {} mm</translation>
    </message>
    <message>
        <source>program {} was not found in the same folder</source>
        <translation>le programme {} n’a pas été trouvé dans le même dossier</translation>
    </message>
    <message>
        <source>program {} is in another dialect, {}</source>
        <translation>le programme {} est d’un autre dialecte, {}</translation>
    </message>
    <message>
        <source>{} is the angle of a rotary axis that the control calculates for a tilted plane</source>
        <translation>{} est l’angle d’un axe rotatif que la commande calcule pour un plan incliné</translation>
    </message>
    <message>
        <source>0 is used; give it as an import option (--tool {}=RADIUS) or in a tool table, or write a TOOL DEF with R before the tool call</source>
        <translation>0 est utilisé&#xa0;; donnez-le comme option de lecture (--tool {}=RADIUS) ou dans une table d’outils, ou programmez un TOOL DEF avec R avant l’appel d’outil</translation>
    </message>
    <message>
        <source>{} has no value</source>
        <translation>{} n’a pas de valeur</translation>
    </message>
    <message>
        <source>{} is not valid in {}</source>
        <translation>{} n’est pas valable dans {}</translation>
    </message>
    <message>
        <source>the {} of {:.3f} mm: {}</source>
        <translation>{} de {} mm&#xa0;: {}</translation>
    </message>
    <message>
        <source>the tool starts inside the approach arc of radius {:.3f} mm</source>
        <translation>l’outil part de l’intérieur de l’arc d’approche de rayon {} mm</translation>
    </message>
    <message>
        <source>the departure ends inside its arc of radius {:.3f} mm</source>
        <translation>la sortie finit à l’intérieur de son arc de rayon {} mm</translation>
    </message>
    <message>
        <source>scaling factor {} is not from 0.000001 to 99.999999</source>
        <translation>le facteur d’échelle {} n’est pas compris entre 0,000001 et 99,999999</translation>
    </message>
    <message>
        <source>{} changes the datum after a motion</source>
        <translation>{} change le point d’origine après un déplacement</translation>
    </message>
    <message>
        <source>cycle {} is not executed: {}</source>
        <translation>le cycle {} n’est pas exécuté&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} is not a parameter</source>
        <translation>{} n’est pas un paramètre</translation>
    </message>
    <message>
        <source>PREDEF for {} without a GLOBAL DEF</source>
        <translation>PREDEF pour {} sans GLOBAL DEF</translation>
    </message>
    <message>
        <source>this value of {} is not supported</source>
        <translation>cette valeur de {} n’est pas prise en charge</translation>
    </message>
    <message>
        <source>cycle {} has no value for Q{}</source>
        <translation>le cycle {} n’a pas de valeur pour Q{}</translation>
    </message>
    <message>
        <source>cycle {}: Q{} is {}, beyond the largest number, 1000000000</source>
        <translation>cycle {}&#xa0;: Q{} vaut {}, au-delà du plus grand nombre admis, 1000000000</translation>
    </message>
    <message>
        <source>cycle {}: Q395=1 measures the depth to the cylinder of the drill</source>
        <translation>cycle {}&#xa0;: Q395=1 mesure la profondeur jusqu’au cylindre du foret</translation>
    </message>
    <message>
        <source>HSC-MODE {} changes nothing in the simulation</source>
        <translation>HSC-MODE {} ne change rien dans la simulation</translation>
    </message>
    <message>
        <source>cycle {} is not supported</source>
        <translation>le cycle {} n’est pas pris en charge</translation>
    </message>
    <message>
        <source>cycle {} ({}) is not supported</source>
        <translation>le cycle {} ({}) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>dwell time {} is negative</source>
        <translation>la temporisation {} est négative</translation>
    </message>
    <message>
        <source>dwell time {} is beyond 1000000000 s</source>
        <translation>la temporisation {} dépasse 1000000000 s</translation>
    </message>
    <message>
        <source>feed F{} is zero or negative</source>
        <translation>l’avance F{} est nulle ou négative</translation>
    </message>
    <message>
        <source>G{} without R</source>
        <translation>G{} sans R</translation>
    </message>
    <message>
        <source>G{} is not supported in this dialect</source>
        <translation>G{} n’est pas pris en charge dans ce dialecte</translation>
    </message>
    <message>
        <source>{} is not a label</source>
        <translation>{} n’est pas une étiquette</translation>
    </message>
    <message>
        <source>label {} is defined twice</source>
        <translation>l’étiquette {} est définie deux fois</translation>
    </message>
    <message>
        <source>label {} does not exist</source>
        <translation>l’étiquette {} n’existe pas</translation>
    </message>
    <message>
        <source>M{} ({}) is not supported</source>
        <translation>M{} ({}) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>{} belongs to another kind of motion than this block</source>
        <translation>{} appartient à un autre type de déplacement que ce bloc</translation>
    </message>
    <message>
        <source>an angle of {:.3f} degrees is opposite to the direction of the arc</source>
        <translation>un angle de {} degrés est opposé au sens de l’arc</translation>
    </message>
    <message>
        <source>rounding {} mm is zero or negative</source>
        <translation>l’arrondi de {} mm est nul ou négatif</translation>
    </message>
    <message>
        <source>chamfer {} mm is zero or negative</source>
        <translation>le chanfrein de {} mm est nul ou négatif</translation>
    </message>
    <message>
        <source>the tolerance T{} is below zero</source>
        <translation>la tolérance T{} est négative</translation>
    </message>
    <message>
        <source>the tolerance T{}</source>
        <translation>la tolérance T{}</translation>
    </message>
    <message>
        <source>{} is not an approach or departure</source>
        <translation>{} n’est ni une approche ni une sortie</translation>
    </message>
    <message>
        <source>cycle {}: Q{} is {}, not a number of places from 1 to {}</source>
        <translation>cycle {}&#xa0;: Q{} vaut {}, ce n’est pas un nombre d’emplacements de 1 à {}</translation>
    </message>
    <message>
        <source>cycle {} repeats a cycle, but none is defined</source>
        <translation>le cycle {} répète un cycle, mais aucun n’est défini</translation>
    </message>
    <message>
        <source>{} is not a number of places from 1 to {}</source>
        <translation>{} n’est pas un nombre d’emplacements de 1 à {}</translation>
    </message>
    <message>
        <source>{} is not a pattern</source>
        <translation>{} n’est pas un motif</translation>
    </message>
    <message>
        <source>{} is not a text</source>
        <translation>{} n’est pas un texte</translation>
    </message>
    <message>
        <source>{} is not an assignment</source>
        <translation>{} n’est pas une affectation</translation>
    </message>
    <message>
        <source>{} does not belong to the formula</source>
        <translation>{} ne fait pas partie de la formule</translation>
    </message>
    <message>
        <source>function {} has no finite value for {} and {}</source>
        <translation>la fonction {} n’a pas de valeur finie pour {} et {}</translation>
    </message>
    <message>
        <source>FN {} is not supported</source>
        <translation>FN {} n’est pas pris en charge</translation>
    </message>
    <message>
        <source>parameter {} does not exist</source>
        <translation>le paramètre {} n’existe pas</translation>
    </message>
    <message>
        <source>the last one is {}{}</source>
        <translation>le dernier est {}{}</translation>
    </message>
    <message>
        <source>the parameter&apos;s value {} is beyond the largest number, 1000000000</source>
        <translation>la valeur du paramètre, {}, dépasse le plus grand nombre admis, 1000000000</translation>
    </message>
    <message>
        <source>{} is not a number or parameter</source>
        <translation>{} n’est ni un nombre ni un paramètre</translation>
    </message>
    <message>
        <source>{} holds a text, not a number</source>
        <translation>{} contient un texte, non un nombre</translation>
    </message>
    <message>
        <source>FN 18 reads ID{} NR{} IDX{}, which depends on the machine</source>
        <translation>FN 18 lit ID{} NR{} IDX{}, ce qui dépend de la machine</translation>
    </message>
    <message>
        <source>{} is set to 0; assign the value of your machine instead</source>
        <translation>{} est mis à 0&#xa0;; affectez plutôt la valeur de votre machine</translation>
    </message>
    <message>
        <source>FN 18 reads the position of {} before the program has moved it</source>
        <translation>FN 18 lit la position de {} avant que le programme ne l’ait déplacé</translation>
    </message>
    <message>
        <source>{} is set to the start position, which is assumed as zero; assign the value of your machine instead</source>
        <translation>{} est mis à la position de départ, supposée nulle&#xa0;; affectez plutôt la valeur de votre machine</translation>
    </message>
    <message>
        <source>{}: the radius of the tool is not known</source>
        <translation>{}&#xa0;: le rayon de l’outil n’est pas connu</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; {}, or write a TOOL DEF with R before the tool call</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; {}, ou programmez un TOOL DEF avec R avant l’appel de l’outil</translation>
    </message>
    <message>
        <source>{} is not X, Y or Z</source>
        <translation>{} n’est ni X, ni Y, ni Z</translation>
    </message>
    <message>
        <source>{} ({}) is not supported</source>
        <translation>{} ({}) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>{}; reported once</source>
        <translation>{}&#xa0;; signalé une seule fois</translation>
    </message>
    <message>
        <source>{} is not a statement of this dialect</source>
        <translation>{} n’est pas une instruction de ce dialecte</translation>
    </message>
    <message>
        <source>{} is not a word of this block</source>
        <translation>{} n’est pas un mot de ce bloc</translation>
    </message>
    <message>
        <source>FT{} (time of the block) is not supported</source>
        <translation>FT{} (durée du bloc) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>R{} (extension by the tool radius) is not supported</source>
        <translation>R{} (prolongement du rayon d’outil) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>M{} calls program {:.0f}, which is neither in the program nor in a file in its folder</source>
        <translation>M{} appelle le programme {}, qui n’est ni dans le programme ni dans un fichier de son dossier</translation>
    </message>
    <message>
        <source>M{} without P</source>
        <translation>M{} sans P</translation>
    </message>
    <message>
        <source>M{} calls file {}, which is neither in the program nor in a file in its folder</source>
        <translation>M{} appelle le fichier {}, qui n’est ni dans le programme ni dans un fichier de son dossier</translation>
    </message>
    <message>
        <source>jump target N{} does not exist</source>
        <translation>la cible de saut N{} n’existe pas</translation>
    </message>
    <message>
        <source>the program repeats from N{} without end</source>
        <translation>le programme se répète sans fin depuis N{}</translation>
    </message>
    <message>
        <source>L{} is not a number of times from 0 to {}</source>
        <translation>L{} n’est pas un nombre de fois de 0 à {}</translation>
    </message>
    <message>
        <source>its motion is missing; add the file &quot;{}&quot; to the program&apos;s folder</source>
        <translation>son déplacement manque&#xa0;; ajoutez le fichier &quot;{}&quot; au dossier du programme</translation>
    </message>
    <message>
        <source>G{} without P</source>
        <translation>G{} sans P</translation>
    </message>
    <message>
        <source>macro program {:.0f} is called, which is neither in the program nor in a file in its folder</source>
        <translation>le macroprogramme {} est appelé, mais n’est ni dans le programme ni dans un fichier de son dossier</translation>
    </message>
    <message>
        <source>o{} is called, which is neither in the program nor in a file in its folder</source>
        <translation>o{} est appelé, mais n’est ni dans le programme ni dans un fichier de son dossier</translation>
    </message>
    <message>
        <source>{} without D</source>
        <translation>{} sans D</translation>
    </message>
    <message>
        <source>{} without D: the radius of the tool is not known</source>
        <translation>{} sans D&#xa0;: le rayon de l’outil n’est pas connu</translation>
    </message>
    <message>
        <source>the radius of offset D{} is not known</source>
        <translation>le rayon du correcteur D{} n’est pas connu</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; {}, or set it with G10 L12 P{} R</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; {}, ou définissez-le par G10 L12 P{} R</translation>
    </message>
    <message>
        <source>{} without {}</source>
        <translation>{} sans {}</translation>
    </message>
    <message>
        <source>{} is selected after motion in {}</source>
        <translation>{} est choisi après un déplacement dans {}</translation>
    </message>
    <message>
        <source>P{} is not a work offset number from {} to {}</source>
        <translation>P{} n’est pas un numéro de décalage d’origine de {} à {}</translation>
    </message>
    <message>
        <source>G68.2 P{} (tilted working plane by points, vectors or projection angles) is not supported</source>
        <translation>G68.2 P{} (plan de travail incliné par points, vecteurs ou angles de projection) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>scale factor {}{} is zero</source>
        <translation>le facteur d’échelle {}{} est nul</translation>
    </message>
    <message>
        <source>{} begins while the position of {} is not known</source>
        <translation>{} commence alors que la position de {} n’est pas connue</translation>
    </message>
    <message>
        <source>{} without {}, the bottom of the hole</source>
        <translation>{} sans {}, le fond du trou</translation>
    </message>
    <message>
        <source>{} without R, the retract plane</source>
        <translation>{} sans R, le plan de retrait</translation>
    </message>
    <message>
        <source>the bottom of the hole at {} {:.4f} mm is on the wrong side of R {:.4f} mm</source>
        <translation>le fond du trou à {} {} mm est du mauvais côté de R {} mm</translation>
    </message>
    <message>
        <source>the direction in which {} retracts from the wall is a control setting</source>
        <translation>la direction dans laquelle {} s’écarte de la paroi est un réglage de la commande</translation>
    </message>
    <message>
        <source>{}{} is not a number of repeats from 0 to {}</source>
        <translation>{}{} n’est pas un nombre de répétitions de 0 à {}</translation>
    </message>
    <message>
        <source>{} with pecks of {} mm</source>
        <translation>{} avec des passes de débourrage de {} mm</translation>
    </message>
    <message>
        <source>{} (hole pattern) needs an active drilling cycle, I and L</source>
        <translation>{} (motif de trous) demande un cycle de perçage actif, I et L</translation>
    </message>
    <message>
        <source>for a control that takes milliseconds, write P{}</source>
        <translation>pour une commande qui compte en millisecondes, programmez P{}</translation>
    </message>
    <message>
        <source>dwell time {}{} is negative</source>
        <translation>la temporisation {}{} est négative</translation>
    </message>
    <message>
        <source>write P{}.0 for seconds</source>
        <translation>programmez P{}.0 pour des secondes</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a variable number</source>
        <translation>&quot;{}&quot; n’est pas un numéro de variable</translation>
    </message>
    <message>
        <source>{} has no valid number</source>
        <translation>{} n’a pas de nombre valable</translation>
    </message>
    <message>
        <source>{} is above the largest number, 1000000000</source>
        <translation>{} dépasse le plus grand nombre admis, 1000000000</translation>
    </message>
    <message>
        <source>the comment {} is not closed</source>
        <translation>le commentaire {} n’est pas fermé</translation>
    </message>
    <message>
        <source>{} does not start a word</source>
        <translation>{} ne commence pas un mot</translation>
    </message>
    <message>
        <source>byte 0x{:02X}</source>
        <translation>l’octet 0x{}</translation>
    </message>
    <message>
        <source>{} follows a statement</source>
        <translation>{} suit une instruction</translation>
    </message>
    <message>
        <source>{} is not an O word</source>
        <translation>{} n’est pas un mot O</translation>
    </message>
    <message>
        <source>a sub inside the sub of line {}</source>
        <translation>un sub à l’intérieur du sub de la ligne {}</translation>
    </message>
    <message>
        <source>{} has no {}</source>
        <translation>{} n’a pas de {}</translation>
    </message>
    <message>
        <source>{} writes to a device</source>
        <translation>{} écrit vers un périphérique</translation>
    </message>
    <message>
        <source>{} is not a known G word</source>
        <translation>{} n’est pas un mot G connu</translation>
    </message>
    <message>
        <source>{} and {} exclude each other in one block</source>
        <translation>{} et {} s’excluent dans un même bloc</translation>
    </message>
    <message>
        <source>{} is used; remove the other</source>
        <translation>{} est utilisé&#xa0;; supprimez l’autre</translation>
    </message>
    <message>
        <source>{} exceeds the 8 G words of coordinates that a block can have</source>
        <translation>{} dépasse les 8 mots G de coordonnées qu’un bloc peut avoir</translation>
    </message>
    <message>
        <source>M{} is read as in LinuxCNC&apos;s own five-axis configurations: X, Y and Z are those of the machine</source>
        <translation>M{} est lu comme dans les configurations à cinq axes de LinuxCNC&#xa0;: X, Y et Z sont ceux de la machine</translation>
    </message>
    <message>
        <source>F{} is in {}/min: LinuxCNC sets the feed before {} of the same block changes the unit</source>
        <translation>F{} est en {}/min&#xa0;: LinuxCNC règle l’avance avant que {} du même bloc ne change l’unité</translation>
    </message>
    <message>
        <source>write {} in a block before it, or give --unit {} if the control starts so</source>
        <translation>programmez {} dans un bloc précédent, ou donnez --unit {} si la commande démarre ainsi</translation>
    </message>
    <message>
        <source>feed F{} is not above zero</source>
        <translation>l’avance F{} n’est pas supérieure à zéro</translation>
    </message>
    <message>
        <source>position words after G80 without a new G0, G1, G2 or G3: {} stops here with an error</source>
        <translation>des mots de position après G80 sans nouveau G0, G1, G2 ou G3&#xa0;: {} s’arrête ici avec une erreur</translation>
    </message>
    <message>
        <source>position words before the first G0, G1, G2 or G3: {} stops here with an error</source>
        <translation>des mots de position avant le premier G0, G1, G2 ou G3&#xa0;: {} s’arrête ici avec une erreur</translation>
    </message>
    <message>
        <source>a rounding or chamfer of {} is not above zero</source>
        <translation>un arrondi ou chanfrein de {} n’est pas supérieur à zéro</translation>
    </message>
    <message>
        <source>,{} in a block that is not a line or an arc</source>
        <translation>,{} dans un bloc qui n’est ni une droite ni un arc</translation>
    </message>
    <message>
        <source>P{} is not a number of turns from 1 to {}</source>
        <translation>P{} n’est pas un nombre de tours de 1 à {}</translation>
    </message>
    <message>
        <source>{}{} is perpendicular to the plane of the arc</source>
        <translation>{}{} est perpendiculaire au plan de l’arc</translation>
    </message>
    <message>
        <source>G187 (smoothness)</source>
        <translation>G187 (douceur)</translation>
    </message>
    <message>
        <source>G5.1 (machining condition from speed to accuracy)</source>
        <translation>G5.1 (condition d’usinage, de la vitesse à la précision)</translation>
    </message>
    <message>
        <source>{}{} of {} changes nothing in the simulation</source>
        <translation>{}{} de {} ne change rien dans la simulation</translation>
    </message>
    <message>
        <source>tolerance {}{} of {} is negative</source>
        <translation>la tolérance {}{} de {} est négative</translation>
    </message>
    <message>
        <source>tolerance {}{} of {}</source>
        <translation>la tolérance {}{} de {}</translation>
    </message>
    <message>
        <source>{} is a command or macro of Klipper</source>
        <translation>{} est une commande ou une macro de Klipper</translation>
    </message>
    <message>
        <source>{} is programmed twice in this block</source>
        <translation>{} est programmé deux fois dans ce bloc</translation>
    </message>
    <message>
        <source>G10 L{} (data setting) is not supported</source>
        <translation>G10 L{} (écriture de données) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>{} is a control command</source>
        <translation>{} est une commande du pupitre</translation>
    </message>
    <message>
        <source>{} without {} and {}</source>
        <translation>{} sans {} ni {}</translation>
    </message>
    <message>
        <source>order L{} of G5.2 is above {}</source>
        <translation>l’ordre L{} de G5.2 dépasse {}</translation>
    </message>
    <message>
        <source>{} is taken</source>
        <translation>{} est utilisé</translation>
    </message>
    <message>
        <source>order P{} of G6.2 is not from {} to {}</source>
        <translation>l’ordre P{} de G6.2 n’est pas compris entre {} et {}</translation>
    </message>
    <message>
        <source>G6.2 of order {} with {} control points and {} knots K</source>
        <translation>G6.2 d’ordre {} avec {} points de contrôle et {} nœuds K</translation>
    </message>
    <message>
        <source>G5.2 with {} control points is too short for order {}</source>
        <translation>G5.2 avec {} points de contrôle est trop court pour l’ordre {}</translation>
    </message>
    <message>
        <source>G5.2 in line {} is not closed by G5.3</source>
        <translation>G5.2 de la ligne {} n’est pas fermé par G5.3</translation>
    </message>
    <message>
        <source>{} is not a word of ISO programs</source>
        <translation>{} n’est pas un mot des programmes ISO</translation>
    </message>
    <message>
        <source>{}{} is above the largest number, 1000000000</source>
        <translation>{}{} dépasse le plus grand nombre admis, 1000000000</translation>
    </message>
    <message>
        <source>#{} is read-only</source>
        <translation>#{} est en lecture seule</translation>
    </message>
    <message>
        <source>#{} is a control-internal value</source>
        <translation>#{} est une valeur interne de la commande</translation>
    </message>
    <message>
        <source>#{} has not been set by the program</source>
        <translation>#{} n’a pas été défini par le programme</translation>
    </message>
    <message>
        <source>#&lt;{}&gt; has not been set</source>
        <translation>#&lt;{}&gt; n’a pas été défini</translation>
    </message>
    <message>
        <source>the program raises alarm {}</source>
        <translation>le programme déclenche l’alarme {}</translation>
    </message>
    <message>
        <source>{}{:.0f} without a decimal point is used as {:.0f} inch</source>
        <translation>{}{} sans point décimal est lu comme {} pouce(s)</translation>
    </message>
    <message>
        <source>{}{:.0f} without a decimal point is used as {:.0f} mm</source>
        <translation>{}{} sans point décimal est lu comme {} mm</translation>
    </message>
    <message>
        <source>{} in a block with X or Y</source>
        <translation>{} dans un bloc avec X ou Y</translation>
    </message>
    <message>
        <source>{}{} has no meaning in this block</source>
        <translation>{}{} n’a pas de sens dans ce bloc</translation>
    </message>
    <message>
        <source>{} has no finite value</source>
        <translation>{} n’a pas de valeur finie</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is missing here</source>
        <translation>il manque ici &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the expression is nested more than {} deep</source>
        <translation>l’expression est imbriquée sur plus de {} niveaux</translation>
    </message>
    <message>
        <source>{} is not a value, variable or function</source>
        <translation>{} n’est ni une valeur, ni une variable, ni une fonction</translation>
    </message>
    <message>
        <source>calls are nested more than {} deep</source>
        <translation>les appels sont imbriqués sur plus de {} niveaux</translation>
    </message>
    <message>
        <source>{:.4g} x {:.4g} x {:.4g} mm cut at {:.4g} mm/min at most look like inches; give --unit inch, or --unit mm if that is right</source>
        <translation>{} x {} x {} mm usinés à {} mm/min au plus ressemblent à des pouces&#xa0;; donnez --unit inch, ou --unit mm si c’est exact</translation>
    </message>
    <message>
        <source>{} moves to a machine position, which the program does not contain</source>
        <translation>{} va à une position machine, que le programme ne contient pas</translation>
    </message>
    <message>
        <source>{} are all zero: the tool has no direction</source>
        <translation>{} sont nuls&#xa0;: l’outil n’a aucune direction</translation>
    </message>
    <message>
        <source>the rotary axes stay; write the vector from the tip to the spindle, such as {}</source>
        <translation>les axes rotatifs ne bougent pas&#xa0;; programmez le vecteur de la pointe vers la broche, comme {}</translation>
    </message>
    <message>
        <source>it does not fit between the adjacent elements; {:.3f} mm are used</source>
        <translation>il ne tient pas entre les éléments voisins&#xa0;; {} mm sont utilisés</translation>
    </message>
    <message>
        <source>at this block a tool of radius {:.4f} mm cuts {:.4f} mm into the contour of line {}</source>
        <translation>à ce bloc, un outil de rayon {} mm entame de {} mm le contour de la ligne {}</translation>
    </message>
    <message>
        <source>the arc&apos;s radius, {:.4f} mm, is smaller than the tool&apos;s, {:.4f} mm</source>
        <translation>le rayon de l’arc, {} mm, est plus petit que celui de l’outil, {} mm</translation>
    </message>
    <message>
        <source>a tool of radius {:.4f} mm does not fit between this block and its neighbours</source>
        <translation>un outil de rayon {} mm ne tient pas entre ce bloc et ses voisins</translation>
    </message>
    <message>
        <source>axis {} turns in feed motions of the tool&apos;s tip</source>
        <translation>l’axe {} tourne pendant des déplacements en avance de la pointe de l’outil</translation>
    </message>
    <message>
        <source>axis {} turns in a feed motion of X, Y and Z without tool centre point control</source>
        <translation>l’axe {} tourne pendant un déplacement en avance de X, Y et Z sans suivi de la pointe de l’outil (RTCP)</translation>
    </message>
    <message>
        <source>axis {} turns by {:g} degrees, from {:g} to {:g}</source>
        <translation>l’axe {} tourne de {} degrés, de {} à {}</translation>
    </message>
    <message>
        <source>the tool&apos;s direction and axis {} are given in one block</source>
        <translation>la direction de l’outil et l’axe {} sont donnés dans un même bloc</translation>
    </message>
    <message>
        <source>the tool turns in a feed move, which is not simulated</source>
        <translation>l’outil tourne dans un déplacement en avance, ce qui n’est pas simulé</translation>
    </message>
    <message>
        <source>the tool turns, which is not simulated</source>
        <translation>l’outil tourne, ce qui n’est pas simulé</translation>
    </message>
    <message>
        <source>axis {} moves to {} in a feed move, which is not simulated</source>
        <translation>l’axe {} va à {} dans un déplacement en avance, ce qui n’est pas simulé</translation>
    </message>
    <message>
        <source>axis {} moves to {}, which is not simulated</source>
        <translation>l’axe {} va à {}, ce qui n’est pas simulé</translation>
    </message>
    <message>
        <source>{}; the time of this axis is not included, so the cycle time is too short; reported once</source>
        <translation>{}&#xa0;; le temps de cet axe n’est pas compté, le temps de cycle est donc trop court&#xa0;; signalé une seule fois</translation>
    </message>
    <message>
        <source>a feed move while the position of {} is not known</source>
        <translation>un déplacement en avance alors que la position de {} n’est pas connue</translation>
    </message>
    <message>
        <source>the centre would fit as {}</source>
        <translation>le centre conviendrait comme {}</translation>
    </message>
    <message>
        <source>the arc&apos;s radius is {:.4f} mm at its start but {:.4f} mm at its end</source>
        <translation>le rayon de l’arc est de {} mm au départ mais de {} mm à la fin</translation>
    </message>
    <message>
        <source>radius {:.4f} mm is too small for ends {:.4f} mm apart</source>
        <translation>le rayon de {} mm est trop petit pour des extrémités distantes de {} mm</translation>
    </message>
    <message>
        <source>the radius must be at least half the distance; {}</source>
        <translation>le rayon doit faire au moins la moitié de la distance&#xa0;; {}</translation>
    </message>
    <message>
        <source>{} is below {} mm</source>
        <translation>{} est inférieure à {} mm</translation>
    </message>
    <message>
        <source>{} mm is used, the smallest that is simulated</source>
        <translation>{} mm est utilisé, la plus petite valeur simulée</translation>
    </message>
    <message>
        <source>exact stops ({})</source>
        <translation>arrêts précis ({})</translation>
    </message>
    <message>
        <source>contour tolerance {} mm</source>
        <translation>tolérance de contour {} mm</translation>
    </message>
    <message>
        <source>blends from {} mm before the corner</source>
        <translation>raccords dès {} mm avant l’angle</translation>
    </message>
    <message>
        <source>orientation tolerance {:.6g} deg</source>
        <translation>tolérance d’orientation {}°</translation>
    </message>
    <message>
        <source>compaction tolerance {} mm</source>
        <translation>tolérance de compactage {} mm</translation>
    </message>
    <message>
        <source>{}, by the program</source>
        <translation>{}, d’après le programme</translation>
    </message>
    <message>
        <source>{}, by --unit</source>
        <translation>{}, d’après --unit</translation>
    </message>
    <message>
        <source>{}, assumed: the program does not define its unit</source>
        <translation>{}, par hypothèse&#xa0;: le programme ne définit pas son unité</translation>
    </message>
    <message>
        <source>this is a program for {}, which is not supported</source>
        <translation>ce programme est écrit pour {}, qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>it is interpreted as ISO and the path shown may be wrong: {}; give --dialect to interpret it as that dialect</source>
        <translation>il est interprété comme de l’ISO et la trajectoire affichée peut être fausse&#xa0;: {}&#xa0;; donnez --dialect pour l’interpréter dans ce dialecte</translation>
    </message>
    <message>
        <source>cycles and curves have made more than {} motions</source>
        <translation>les cycles et les courbes ont produit plus de {} déplacements</translation>
    </message>
    <message>
        <source>loops and calls have run {} lines without coming to an end</source>
        <translation>les boucles et les appels ont parcouru {} lignes sans se terminer</translation>
    </message>
    <message>
        <source>the program ends in line {}; the text after it is not executed</source>
        <translation>le programme se termine à la ligne {}&#xa0;; le texte qui suit n’est pas exécuté</translation>
    </message>
    <message>
        <source>{} does not name a subprogram</source>
        <translation>{} ne désigne pas un sous-programme</translation>
    </message>
    <message>
        <source>TURN={} is not a number of turns from 0 to {}</source>
        <translation>TURN={} n’est pas un nombre de tours de 0 à {}</translation>
    </message>
    <message>
        <source>opening angle AR={} is not between 0 and 360 degrees</source>
        <translation>l’angle d’ouverture AR={} n’est pas entre 0 et 360 degrés</translation>
    </message>
    <message>
        <source>&quot;the array&quot;</source>
        <translation>le tableau</translation>
    </message>
    <message>
        <source>FOR cannot count with {}</source>
        <translation>FOR ne peut pas compter avec {}</translation>
    </message>
    <message>
        <source>{} is not a subprogram</source>
        <translation>{} n’est pas un sous-programme</translation>
    </message>
    <message>
        <source>subprogram {} is neither in the program nor a file in its folder</source>
        <translation>le sous-programme {} n’est ni dans le programme ni un fichier de son dossier</translation>
    </message>
    <message>
        <source>tool radius {} is negative</source>
        <translation>le rayon d’outil {} est négatif</translation>
    </message>
    <message>
        <source>{} without a tool: its radius is not known</source>
        <translation>{} sans outil&#xa0;: son rayon n’est pas connu</translation>
    </message>
    <message>
        <source>{}: the radius of T{} D{} is not known</source>
        <translation>{}&#xa0;: le rayon de T{} D{} n’est pas connu</translation>
    </message>
    <message>
        <source>the path shown is the programmed contour; {}, or set it with $TC_DP6[T,D]=</source>
        <translation>la trajectoire affichée est le contour programmé&#xa0;; {}, ou définissez-le par $TC_DP6[T,D]=</translation>
    </message>
    <message>
        <source>G{} is selected after motion in G{}</source>
        <translation>G{} est choisi après un déplacement dans G{}</translation>
    </message>
    <message>
        <source>RNDM={} is negative</source>
        <translation>RNDM={} est négatif</translation>
    </message>
    <message>
        <source>a rounding or chamfer of {} is negative</source>
        <translation>un arrondi ou chanfrein de {} est négatif</translation>
    </message>
    <message>
        <source>the depth of CYCLE{} at the tool&apos;s diameter or shank is not supported</source>
        <translation>la profondeur de CYCLE{} au diamètre ou à la queue de l’outil n’est pas prise en charge</translation>
    </message>
    <message>
        <source>{} is not a number of holes from 1 to {}</source>
        <translation>{} n’est pas un nombre de trous de 1 à {}</translation>
    </message>
    <message>
        <source>subprogram {} at a pattern of holes is not supported</source>
        <translation>le sous-programme {} sur un motif de trous n’est pas pris en charge</translation>
    </message>
    <message>
        <source>CYCLE832 with tolerance {} and code {} is out of range</source>
        <translation>CYCLE832 avec la tolérance {} et le code {} dépasse les bornes</translation>
    </message>
    <message>
        <source>CYCLE832 with tolerance {} and machining type 0 switches its settings off</source>
        <translation>CYCLE832 avec la tolérance {} et le type d’usinage 0 désactive ses réglages</translation>
    </message>
    <message>
        <source>machining type {} of CYCLE832 changes nothing in the simulation</source>
        <translation>le type d’usinage {} de CYCLE832 ne change rien dans la simulation</translation>
    </message>
    <message>
        <source>CYCLE800 with mode {} is not supported</source>
        <translation>CYCLE800 avec le mode {} n’est pas pris en charge</translation>
    </message>
    <message>
        <source>the tool retracts before the axes turn (_FR {} of CYCLE800)</source>
        <translation>l’outil se dégage avant que les axes tournent (_FR {} de CYCLE800)</translation>
    </message>
    <message>
        <source>{} is not a supported type</source>
        <translation>{} n’est pas un type pris en charge</translation>
    </message>
    <message>
        <source>{} after PROC is not an attribute</source>
        <translation>{} après PROC n’est pas un attribut</translation>
    </message>
    <message>
        <source>parameter {} has no value</source>
        <translation>le paramètre {} n’a pas de valeur</translation>
    </message>
    <message>
        <source>array parameter {} has {} elements, the argument has {}</source>
        <translation>le paramètre tableau {} a {} éléments, l’argument en a {}</translation>
    </message>
    <message>
        <source>a dwell of {} revolutions without a spindle speed</source>
        <translation>une temporisation de {} tours sans vitesse de broche</translation>
    </message>
    <message>
        <source>{} has no matching start or end</source>
        <translation>{} n’a pas de début ou de fin correspondants</translation>
    </message>
    <message>
        <source>{} after a condition is not a jump</source>
        <translation>{} après une condition n’est pas un saut</translation>
    </message>
    <message>
        <source>{} is not a settable frame from 0 to {}</source>
        <translation>{} n’est pas un frame réglable de 0 à {}</translation>
    </message>
    <message>
        <source>{} is not a part of a frame (TR, FI, RT, SC, MI)</source>
        <translation>{} n’est pas une partie de frame (TR, FI, RT, SC, MI)</translation>
    </message>
    <message>
        <source>{} is not a supported frame</source>
        <translation>{} n’est pas un frame pris en charge</translation>
    </message>
    <message>
        <source>{} is a control-internal value</source>
        <translation>{} est une valeur interne de la commande</translation>
    </message>
    <message>
        <source>label {} does not exist in the program</source>
        <translation>l’étiquette {} n’existe pas dans le programme</translation>
    </message>
    <message>
        <source>label {} does not exist after this line</source>
        <translation>l’étiquette {} n’existe pas après cette ligne</translation>
    </message>
    <message>
        <source>label {} does not exist before this line</source>
        <translation>l’étiquette {} n’existe pas avant cette ligne</translation>
    </message>
    <message>
        <source>{} (thread) is shown as a line</source>
        <translation>{} (filetage) est affiché comme une droite</translation>
    </message>
    <message>
        <source>{}={} is negative</source>
        <translation>{}={} est négatif</translation>
    </message>
    <message>
        <source>tolerance {} mm of CYCLE832</source>
        <translation>la tolérance de {} mm de CYCLE832</translation>
    </message>
    <message>
        <source>a polynomial of axis {} is not supported</source>
        <translation>un polynôme de l’axe {} n’est pas pris en charge</translation>
    </message>
    <message>
        <source>the coordinates are used for {} and nothing moves; write a block for each</source>
        <translation>les coordonnées servent à {} et rien ne se déplace&#xa0;; programmez un bloc pour chacun</translation>
    </message>
    <message>
        <source>weight PW={} is not above zero</source>
        <translation>le poids PW={} n’est pas supérieur à zéro</translation>
    </message>
    <message>
        <source>{} does not start a word or statement</source>
        <translation>{} ne commence ni mot ni instruction</translation>
    </message>
    <message>
        <source>assignment to {} is not supported</source>
        <translation>l’affectation de {} n’est pas prise en charge</translation>
    </message>
    <message>
        <source>{} is not a known variable, address or axis</source>
        <translation>{} n’est ni une variable, ni une adresse, ni un axe connus</translation>
    </message>
    <message>
        <source>an increment of {} after a change of frame also traverses the change, {:.6g} mm</source>
        <translation>un incrément de {} après un changement de frame parcourt aussi ce changement, {} mm</translation>
    </message>
    <message>
        <source>ANG={} needs exactly one coordinate of the plane</source>
        <translation>ANG={} demande exactement une coordonnée du plan</translation>
    </message>
    <message>
        <source>a line at ANG={} does not reach the given coordinate</source>
        <translation>une droite à ANG={} n’atteint pas la coordonnée donnée</translation>
    </message>
    <message>
        <source>the program does not define {}</source>
        <translation>le programme ne définit pas {}</translation>
    </message>
    <message>
        <source>the block does not move; define data of the machine (GUD) at the program&apos;s top, &quot;DEF REAL {}=&quot;</source>
        <translation>le bloc n’a pas de déplacement&#xa0;; définissez les données de la machine (GUD) en tête du programme, &quot;DEF REAL {}=&quot;</translation>
    </message>
    <message>
        <source>R{} is not an R parameter from R0 to R{}</source>
        <translation>R{} n’est pas un paramètre R de R0 à R{}</translation>
    </message>
    <message>
        <source>R{} is used before the program sets it</source>
        <translation>R{} est utilisé avant que le programme ne le définisse</translation>
    </message>
    <message>
        <source>text {} is not a number</source>
        <translation>le texte {} n’est pas un nombre</translation>
    </message>
    <message>
        <source>value {} is above the largest number, 1000000000</source>
        <translation>la valeur {} dépasse le plus grand nombre admis, 1000000000</translation>
    </message>
    <message>
        <source>{} is not a number of array elements from 1 to {}</source>
        <translation>{} n’est pas un nombre d’éléments de tableau de 1 à {}</translation>
    </message>
    <message>
        <source>{} has no element {}, its largest index is {}</source>
        <translation>{} n’a pas d’élément {}, son plus grand indice est {}</translation>
    </message>
    <message>
        <source>{} more of this kind up to line {}</source>
        <translation>{} de plus de ce type jusqu’à la ligne {}</translation>
    </message>
    <message>
        <source>offsets without a value are assumed as zero, so parts of the path overlap; give them as an import option, --offset {}=X,Y,Z</source>
        <translation>les décalages sans valeur sont supposés nuls, des parties de la trajectoire se recouvrent donc&#xa0;; donnez-les en option de lecture, --offset {}=X,Y,Z</translation>
    </message>
    <message>
        <source>{}: is larger than 4 GiB; split the program</source>
        <translation>{}&#xa0;: fichier de plus de 4 Gio&#xa0;; divisez le programme</translation>
    </message>
    <message>
        <source>{}: is not a text file ({}); give an NC program as ASCII, UTF-8 or Latin-1 text</source>
        <translation>{}&#xa0;: n’est pas un fichier texte ({})&#xa0;; donnez un programme CN en texte ASCII, UTF-8 ou Latin-1</translation>
    </message>
    <message>
        <source>it has {} control characters</source>
        <translation>il contient {} caractères de commande</translation>
    </message>
    <message>
        <source>{}: cannot be read: {}</source>
        <translation>{}&#xa0;: lecture impossible&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}:{}: the line is {} bytes long, more than the {} of any NC program; check the file&apos;s line ends</source>
        <translation>{}:{}&#xa0;: la ligne fait {} octets, plus que les {} de tout programme CN&#xa0;; vérifiez les fins de ligne du fichier</translation>
    </message>
    <message>
        <source>{}: does not exist; check the path</source>
        <translation>{}&#xa0;: n’existe pas&#xa0;; vérifiez le chemin</translation>
    </message>
    <message>
        <source>{}: is a directory; give the NC program inside it</source>
        <translation>{}&#xa0;: est un dossier&#xa0;; donnez le programme CN qu’il contient</translation>
    </message>
    <message>
        <source>{}: cannot be opened: {}</source>
        <translation>{}&#xa0;: ouverture impossible&#xa0;: {}</translation>
    </message>
    <message>
        <source>tool table &apos;{}&apos;, line {}: {} is not a number</source>
        <translation>table d’outils &apos;{}&apos;, ligne {}&#xa0;: {} n’est pas un nombre</translation>
    </message>
    <message>
        <source>cutter radii are those of tool table &apos;{}&apos;</source>
        <translation>les rayons d’outil sont ceux de la table d’outils &apos;{}&apos;</translation>
    </message>
    <message>
        <source>give it as an import option (--tool {}=RADIUS) or in a tool table, or say that the path is already compensated (--wear-only)</source>
        <translation>donnez-le en option de lecture (--tool {}=RADIUS) ou dans une table d’outils, ou indiquez que la trajectoire est déjà corrigée (--wear-only)</translation>
    </message>
    <message>
        <source>{} is not a letter with a number</source>
        <translation>{} n’est pas une lettre suivie d’un nombre</translation>
    </message>
    <message>
        <source>tool table &apos;{}&apos;, line {}, column {}: {}</source>
        <translation>table d’outils &apos;{}&apos;, ligne {}, colonne {}&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a supported tool table; give lines such as &quot;T1 D10&quot; or &quot;$TC_DP6[1,1]=5&quot;, &quot;G10 L12 P1 R5&quot;, or columns headed T and R</source>
        <translation>&apos;{}&apos; n’est pas une table d’outils connue&#xa0;; donnez des lignes comme &quot;T1 D10&quot; ou &quot;$TC_DP6[1,1]=5&quot;, &quot;G10 L12 P1 R5&quot;, ou des colonnes intitulées T et R</translation>
    </message>
    <message>
        <source>axis {} turns by {:.4g} degrees within one block for a tool vector</source>
        <translation>l’axe {} tourne de {} degrés dans un seul bloc pour un vecteur d’outil</translation>
    </message>
    <message>
        <source>axis {} holds the feed at {:.4g} of {:.4g} mm/min near its singular position: the tool is {:.2g} degrees from its axis</source>
        <translation>l’axe {} retient l’avance à {} sur {} mm/min près de sa position singulière&#xa0;: l’outil est à {} degrés de son axe</translation>
    </message>
    <message>
        <source>lines {} to {}, one of {} such places; tilting the part by some degrees in the clamping takes the path away from it</source>
        <translation>lignes {} à {}, l’un de {} endroits de ce type&#xa0;; incliner la pièce de quelques degrés dans le bridage en éloigne la trajectoire</translation>
    </message>
    <message>
        <source>axis {} goes to {:g} degrees, beyond its travel from {:g} to {:g}</source>
        <translation>l’axe {} va à {} degrés, au-delà de sa course de {} à {}</translation>
    </message>
    <message>
        <source>the tool vector</source>
        <translation>du vecteur d’outil</translation>
    </message>
    <message>
        <source>the tilted plane</source>
        <translation>du plan incliné</translation>
    </message>
    <message>
        <source>the tool vector in the part as it is turned</source>
        <translation>du vecteur d’outil dans la pièce telle qu’elle est tournée</translation>
    </message>
    <message>
        <source>the tilted plane in the part as it is turned</source>
        <translation>du plan incliné dans la pièce telle qu’elle est tournée</translation>
    </message>
    <message>
        <source>no position of the rotary axes of machine &apos;{}&apos; gives the tool the direction {:.4g}, {:.4g}, {:.4g} of {}</source>
        <translation>aucune position des axes rotatifs de la machine &apos;{}&apos; ne donne à l’outil la direction {}, {}, {} {}</translation>
    </message>
    <message>
        <source>no position of the rotary axes with {} of axis {} gives the tool the direction of the tilted plane within its travel</source>
        <translation>aucune position des axes rotatifs avec {} de l’axe {} ne donne à l’outil la direction du plan incliné dans sa course</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no signal that is known as the position of X, Y or Z; it has {}; say which, as --columns x=1:mm,y=2:mm</source>
        <translation>&apos;{}&apos; n’a aucun signal reconnu comme position de X, Y ou Z&#xa0;; signaux&#xa0;: {}&#xa0;; indiquez lesquels, comme --columns x=1:mm,y=2:mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no record of a SINUMERIK trace</source>
        <translation>&apos;{}&apos; ne contient aucune donnée d’une trace SINUMERIK</translation>
    </message>
    <message>
        <source>the XML ends early: {}</source>
        <translation>le XML se termine trop tôt&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}:{}: {}; this is no whole XML file</source>
        <translation>{}:{}&#xa0;: {}&#xa0;; ce n’est pas un fichier XML complet</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no column &apos;{}&apos; for {}; {}</source>
        <translation>&apos;{}&apos; n’a pas de colonne &apos;{}&apos; pour {}&#xa0;; {}</translation>
    </message>
    <message>
        <source>it has {} columns without names</source>
        <translation>il a {} colonnes sans nom</translation>
    </message>
    <message>
        <source>it has {}</source>
        <translation>il contient {}</translation>
    </message>
    <message>
        <source>the trace has no set positions of {}: the actual ones are used instead</source>
        <translation>la trace n’a pas de positions de consigne de {}&#xa0;: les positions réelles sont utilisées à leur place</translation>
    </message>
    <message>
        <source>the time has no unit and rises by {:.6g} a sample: milliseconds are assumed</source>
        <translation>le temps n’a pas d’unité et croît de {} par échantillon&#xa0;: des millisecondes sont supposées</translation>
    </message>
    <message>
        <source>say it: --columns time={}:ms</source>
        <translation>l’indiquer&#xa0;: --columns time={}:ms</translation>
    </message>
    <message>
        <source>the trace has no times: one sample each {:.6g} ms is taken from the servo period of the machine</source>
        <translation>la trace n’a pas de temps&#xa0;: un échantillon toutes les {} ms, d’après la période d’asservissement de la machine</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no trace: no row of numbers in its first {} lines; known are LinuxCNC halsampler, SINUMERIK trace (XML), TwinCAT Scope (text) and tables of samples</source>
        <translation>&apos;{}&apos; n’est pas une trace&#xa0;: aucune ligne de nombres dans ses {} premières lignes&#xa0;; sont connus halsampler de LinuxCNC, la trace SINUMERIK (XML), TwinCAT Scope (texte) et les tables d’échantillons</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no column that is known as the position of X, Y or Z; it has {}; say which, as --columns x=2:mm,y=3:mm</source>
        <translation>&apos;{}&apos; n’a aucune colonne reconnue comme position de X, Y ou Z&#xa0;; colonnes&#xa0;: {}&#xa0;; indiquez lesquelles, comme --columns x=2:mm,y=3:mm</translation>
    </message>
    <message>
        <source>the time goes back from {:.6g} s to {:.6g} s</source>
        <translation>le temps revient de {} s à {} s</translation>
    </message>
    <message>
        <source>{}:{}: the trace has more than {} million samples</source>
        <translation>{}:{}&#xa0;: la trace compte plus de {} millions d’échantillons</translation>
    </message>
    <message>
        <source>the time goes back once; the longest part with {} of {} samples is used</source>
        <translation>le temps recule une fois ; la plus longue partie, {} des {} échantillons, est utilisée</translation>
    </message>
    <message>
        <source>the time goes back {} times; the longest part with {} of {} samples is used</source>
        <translation>le temps revient en arrière {} fois&#xa0;; la partie la plus longue, {} échantillons sur {}, est utilisée</translation>
    </message>
    <message>
        <source>{} missing positions are interpolated between their neighbours</source>
        <translation>positions manquantes interpolées entre leurs voisines&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} positions that are missing for long are those before them</source>
        <translation>{} positions absentes pendant longtemps gardent leur dernière valeur</translation>
    </message>
    <message>
        <source>{:.6g} ms without a sample at {:.6g} s</source>
        <translation>{} ms sans échantillon à {} s</translation>
    </message>
    <message>
        <source>{} more stretches without samples, {:.6g} s in all</source>
        <translation>autres tronçons sans échantillons&#xa0;: {}, {} s en tout</translation>
    </message>
    <message>
        <source>samples are {:.3g} ms apart, give or take {:.3g} ms</source>
        <translation>les échantillons sont espacés de {} ms, à {} ms près</translation>
    </message>
    <message>
        <source>one sample each {:.4g} ms: ramps and corners that last less than {:.4g} ms cannot be told apart</source>
        <translation>un échantillon toutes les {} ms&#xa0;: rampes et angles de moins de {} ms ne se distinguent pas</translation>
    </message>
    <message>
        <source>the sample at {:.6g} s lies {:.4g} mm beside those before and after it</source>
        <translation>l’échantillon à {} s se trouve à {} mm de ceux qui l’entourent</translation>
    </message>
    <message>
        <source>the position jumps by {:.4g} mm within {:.4g} ms at {:.6g} s</source>
        <translation>la position saute de {} mm en {} ms à {} s</translation>
    </message>
    <message>
        <source>{} more jumps of the position</source>
        <translation>{} autres sauts de la position</translation>
    </message>
    <message>
        <source>the positions of the trace move at {:.3g} % of the feed that it records: its sampling rate is wrong</source>
        <translation>les positions de la trace avancent à {} % de l’avance qu’elle enregistre&#xa0;: sa cadence d’échantillonnage est fausse</translation>
    </message>
    <message>
        <source>give the right rate, {0:.0f} samples a second, as --columns linuxcnc,rate={0:.0f}; or leave the column of the feed out</source>
        <translation>donnez la bonne cadence, {0} échantillons par seconde, comme --columns linuxcnc,rate={0}&#xa0;; ou omettez la colonne de l’avance</translation>
    </message>
    <message>
        <source>a row without numbers is skipped, the first is &apos;{}&apos;</source>
        <translation>une ligne sans nombres est ignorée&#xa0;: «&#xa0;{}&#xa0;»</translation>
    </message>
    <message>
        <source>{} rows without numbers are skipped, the first is &apos;{}&apos;</source>
        <translation>{} lignes sans nombres sont ignorées, la première est «&#xa0;{}&#xa0;»</translation>
    </message>
    <message>
        <source>{} samples at the time of the one before are skipped</source>
        <translation>échantillons ignorés, au même temps que le précédent&#xa0;: {}</translation>
    </message>
    <message>
        <source>{} samples with a time a little before that of the sample ahead are skipped</source>
        <translation>{} échantillons dont le temps précède un peu celui de l’échantillon d’avant sont omis</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no position of X, Y or Z; name their columns, as --columns x=2:mm,y=3:mm</source>
        <translation>&apos;{}&apos; n’a pas de position de X, Y ou Z&#xa0;; nommez leurs colonnes, comme --columns x=2:mm,y=3:mm</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has too few samples whose times rise: {}; a trace has at least {}</source>
        <translation>&apos;{}&apos; a trop peu d’échantillons dont le temps croît&#xa0;: {}&#xa0;; il en faut au moins {}</translation>
    </message>
    <message>
        <source>column specification: {}</source>
        <translation>spécification des colonnes&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}={} must be a number from {} to {}</source>
        <translation>{}={} doit être un nombre de {} à {}</translation>
    </message>
    <message>
        <source>separator={} must be tab, comma, semicolon or blank</source>
        <translation>separator={} doit être tab, comma, semicolon ou blank</translation>
    </message>
    <message>
        <source>decimal={} must be point or comma</source>
        <translation>decimal={} doit être point ou comma</translation>
    </message>
    <message>
        <source>{} cannot have an offset, {}; positions of axes can</source>
        <translation>{} ne peut pas avoir de décalage, {}&#xa0;; les positions des axes le peuvent</translation>
    </message>
    <message>
        <source>{}= needs the number or the name of a column, such as {}=2</source>
        <translation>{}= demande le numéro ou le nom d’une colonne, par exemple {}=2</translation>
    </message>
    <message>
        <source>unit &apos;{}&apos; of {} is not known; known: {}</source>
        <translation>l’unité &apos;{}&apos; de {} n’est pas connue&#xa0;; unités connues&#xa0;: {}</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; {}</source>
        <translation>clé &apos;{}&apos; inconnue&#xa0;; {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not KEY=VALUE</source>
        <translation>&apos;{}&apos; n’est pas de la forme KEY=VALUE</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no preset of columns; known: {}; or write a specification such as time=1:ms,x=2:mm,y=3:mm</source>
        <translation>&apos;{}&apos; n’est pas un préréglage de colonnes&#xa0;; sont connus&#xa0;: {}&#xa0;; ou écrivez une spécification comme time=1:ms,x=2:mm,y=3:mm</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a folder; give a trace</source>
        <translation>&apos;{}&apos; est un dossier&#xa0;; il faut une trace</translation>
    </message>
    <message>
        <source>cannot read trace &apos;{}&apos;: {}</source>
        <translation>la trace &apos;{}&apos; ne peut pas être lue&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is written in UTF-16; save it as UTF-8</source>
        <translation>&apos;{}&apos; est écrit en UTF-16&#xa0;; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>{}:{}: the line is longer than 1 MiB; this is not a table of samples</source>
        <translation>{}:{}&#xa0;: la ligne dépasse 1 Mio&#xa0;; ce n’est pas une table d’échantillons</translation>
    </message>
    <message>
        <source>{}:{}: no samples follow the head of the TwinCAT Scope export</source>
        <translation>{}:{}&#xa0;: aucun échantillon ne suit l’en-tête de l’export TwinCAT Scope</translation>
    </message>
    <message>
        <source>a film of {:.0f} x {:.0f} units is too small for the view and the charts; use a larger --size or a smaller --scale</source>
        <translation>un film de {} x {} unités est trop petit pour la vue et les graphiques&#xa0;; prenez un --size plus grand ou un --scale plus petit</translation>
    </message>
    <message>
        <source>a film of {:.0f} x {:.0f} units is too small; use a larger --size or a smaller --scale</source>
        <translation>un film de {} x {} unités est trop petit&#xa0;; prenez un --size plus grand ou un --scale plus petit</translation>
    </message>
    <message>
        <source>the film would begin at {:.6g} s and end at {:.6g} s; give --from a time before that of --to</source>
        <translation>le film commencerait à {} s et finirait à {} s&#xa0;; donnez à --from un temps avant celui de --to</translation>
    </message>
    <message>
        <source>the film would end at {:.6g} s, but the run takes {:.6g} s; use a smaller --to</source>
        <translation>le film finirait à {} s, mais la simulation dure {} s&#xa0;; prenez un --to plus petit</translation>
    </message>
    <message>
        <source>the film would have {} frames, and at most {} can be written; use --speed {:.6g} or more, a smaller --fps, or a shorter stretch by --from and --to</source>
        <translation>le film aurait {} images, et {} au plus peuvent être écrites&#xa0;; prenez --speed {} ou plus, un --fps plus petit, ou une partie plus courte par --from et --to</translation>
    </message>
    <message>
        <source>machine &apos;{}&apos; has no rotary axes to draw; choose a machine with [kinematics], such as five-axis-table-ac</source>
        <translation>la machine &apos;{}&apos; n’a pas d’axes rotatifs à dessiner&#xa0;; choisissez une machine avec [kinematics], comme five-axis-table-ac</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: {}</source>
        <translation>&apos;{}&apos; ne peut pas être écrit&#xa0;: {}</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos; as a picture; its name must end in .png, .svg or .pdf</source>
        <translation>&apos;{}&apos; ne peut pas être écrit comme image&#xa0;; son nom doit finir par .png, .svg ou .pdf</translation>
    </message>
    <message>
        <source>charts of {} x {} units are too small; they need at least {} x {}: use a larger --size or a smaller --scale</source>
        <translation>des graphiques de {} x {} unités sont trop petits&#xa0;; il leur faut au moins {} x {}&#xa0;: prenez un --size plus grand ou un --scale plus petit</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>vouliez-vous dire {}&#xa0;?</translation>
    </message>
    <message>
        <source>unknown placeholder {}; {}</source>
        <translation>emplacement {} inconnu&#xa0;; {}</translation>
    </message>
    <message>
        <source>&apos;{{&apos; without &apos;}}&apos;</source>
        <translation>&apos;{{&apos; sans &apos;}}&apos;</translation>
    </message>
    <message>
        <source>section {} is not closed; write {} after it</source>
        <translation>la section {} n’est pas fermée&#xa0;; écrivez {} après elle</translation>
    </message>
    <message>
        <source>{} closes no section</source>
        <translation>{} ne ferme aucune section</translation>
    </message>
    <message>
        <source>{} closes no section; {} is open</source>
        <translation>{} ne ferme aucune section&#xa0;; {} est ouverte</translation>
    </message>
    <message>
        <source>the text {} has no quote at its end</source>
        <translation>le texte {} n’a pas de guillemet à sa fin</translation>
    </message>
    <message>
        <source>cannot read the template &apos;{}&apos;: {}</source>
        <translation>le modèle de page &apos;{}&apos; ne peut pas être lu&#xa0;: {}</translation>
    </message>
    <message>
        <source>it has {} bytes, and a template may have {}</source>
        <translation>il compte {} octets, et un modèle de page peut en avoir {}</translation>
    </message>
    <message>
        <source>the 3D view would have {} x {} pixels, and each side may have 1 to {}; use a smaller --size, --scale or --dpi</source>
        <translation>la vue 3D aurait {} x {} pixels, et chaque côté peut en avoir de 1 à {}&#xa0;; prenez un --size, --scale ou --dpi plus petit</translation>
    </message>
    <message>
        <source>a sheet of {:.0f} x {:.0f} units is too small; it needs at least {:.0f} on its longer and {:.0f} on its shorter side: use a larger --size or a smaller --scale</source>
        <translation>une fiche de {} x {} unités est trop petite&#xa0;; il lui faut au moins {} sur le grand côté et {} sur le petit&#xa0;: prenez un --size plus grand ou un --scale plus petit</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>ne peut pas être lue&#xa0;: {}</translation>
    </message>
    <message>
        <source>has {} bytes, and a picture may have {}</source>
        <translation>compte {} octets, et une image peut en avoir {}</translation>
    </message>
    <message>
        <source>is not a picture; PNG, JPEG, SVG and other formats of Qt are supported</source>
        <translation>n’est pas une image&#xa0;; PNG, JPEG, SVG et d’autres formats de Qt sont pris en charge</translation>
    </message>
    <message>
        <source>&apos;{}&apos; {}</source>
        <translation>&apos;{}&apos; {}</translation>
    </message>
    <message>
        <source>is an external style sheet; put its rules into &lt;style&gt;</source>
        <translation>est une feuille de style externe&#xa0;; mettez ses règles dans &lt;style&gt;</translation>
    </message>
    <message>
        <source>contains no picture; PNG, JPEG, SVG and other formats of Qt are supported</source>
        <translation>ne contient pas d’image&#xa0;; PNG, JPEG, SVG et d’autres formats de Qt sont pris en charge</translation>
    </message>
    <message>
        <source>is a URL; save the picture in the template&apos;s folder and give its file name</source>
        <translation>est une URL&#xa0;; enregistrez l’image dans le dossier du modèle et donnez son nom de fichier</translation>
    </message>
    <message>
        <source>{}; pictures are looked for in the template&apos;s folder</source>
        <translation>{}&#xa0;; les images sont cherchées dans le dossier du modèle</translation>
    </message>
    <message>
        <source>picture &apos;{}&apos; {}</source>
        <translation>l’image &apos;{}&apos; {}</translation>
    </message>
    <message>
        <source>line {}, column {}</source>
        <translation>ligne {}, colonne {}</translation>
    </message>
    <message>
        <source>cannot read session &apos;{}&apos;: {}</source>
        <translation>la session &apos;{}&apos; ne peut pas être lue&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is larger than 64 MiB and cannot be a session</source>
        <translation>&apos;{}&apos; dépasse 64 Mio et ne peut pas être une session</translation>
    </message>
    <message>
        <source>cannot write session &apos;{}&apos;: {}</source>
        <translation>la session &apos;{}&apos; ne peut pas être écrite&#xa0;: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a session: {} ({})</source>
        <translation>&apos;{}&apos; n’est pas une session&#xa0;: {} ({})</translation>
    </message>
    <message>
        <source>cannot use session &apos;{}&apos;: {}</source>
        <translation>la session &apos;{}&apos; ne peut pas être utilisée&#xa0;: {}</translation>
    </message>
    <message>
        <source>it is not a Feedscope session: its &quot;format&quot; is not &quot;{}&quot;</source>
        <translation>ce n’est pas une session de Feedscope&#xa0;: son &quot;format&quot; n’est pas &quot;{}&quot;</translation>
    </message>
    <message>
        <source>it is of version {}, written by a newer Feedscope; this one reads up to version {}</source>
        <translation>elle est de la version {}, écrite par un Feedscope plus récent&#xa0;; celui-ci lit jusqu’à la version {}</translation>
    </message>
    <message>
        <source>its &quot;version&quot; is not a whole number from 1 to {}</source>
        <translation>sa &quot;version&quot; n’est pas un nombre entier de 1 à {}</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; must be tables; begin each with [[{0}]]</source>
        <translation>&apos;{0}&apos; doit contenir des tables&#xa0;; commencez chacune par [[{0}]]</translation>
    </message>
    <message>
        <source>Home position X</source>
        <translation>Position d’origine X</translation>
    </message>
    <message>
        <source>Home position Y</source>
        <translation>Position d’origine Y</translation>
    </message>
    <message>
        <source>Home position Z</source>
        <translation>Position d’origine Z</translation>
    </message>
    <message>
        <source>Tool change position X</source>
        <translation>Position de changement d’outil X</translation>
    </message>
    <message>
        <source>Tool change position Y</source>
        <translation>Position de changement d’outil Y</translation>
    </message>
    <message>
        <source>Tool change position Z</source>
        <translation>Position de changement d’outil Z</translation>
    </message>
    <message>
        <source>Part zero X</source>
        <translation>Origine pièce X</translation>
    </message>
    <message>
        <source>Part zero Y</source>
        <translation>Origine pièce Y</translation>
    </message>
    <message>
        <source>Part zero Z</source>
        <translation>Origine pièce Z</translation>
    </message>
    <message>
        <source>Cutting feed X</source>
        <translation>Avance de coupe X</translation>
    </message>
    <message>
        <source>Cutting feed Y</source>
        <translation>Avance de coupe Y</translation>
    </message>
    <message>
        <source>Cutting feed Z</source>
        <translation>Avance de coupe Z</translation>
    </message>
    <message>
        <source>Angle of the part about X</source>
        <translation>Angle de la pièce autour de X</translation>
    </message>
    <message>
        <source>Angle of the part about Y</source>
        <translation>Angle de la pièce autour de Y</translation>
    </message>
    <message>
        <source>Angle of the part about Z</source>
        <translation>Angle de la pièce autour de Z</translation>
    </message>
    <message>
        <source>{}{} without a decimal point is used as {} seconds</source>
        <translation>{}{} sans point décimal est lu comme {} secondes</translation>
    </message>
    <message>
        <source>P{} is used as {} seconds, as in {}</source>
        <translation>P{} est lu comme {} secondes, comme dans {}</translation>
    </message>
    <message>
        <source>P{} without a decimal point is used as {} milliseconds</source>
        <translation>P{} sans point décimal est lu comme {} millisecondes</translation>
    </message>
    <message>
        <source>KEY= is missing</source>
        <translation>KEY= manque</translation>
    </message>
    <message>
        <source>{} is listed twice</source>
        <translation>{} est donné deux fois</translation>
    </message>
    <message>
        <source>the value is missing</source>
        <translation>la valeur manque</translation>
    </message>
    <message>
        <source>{} values; at most {} are possible</source>
        <translation>{} valeurs&#xa0;; {} au plus sont possibles</translation>
    </message>
    <message>
        <source>Not in the cycle time: {}</source>
        <translation>Hors temps de cycle&#xa0;: {}</translation>
    </message>
    <message>
        <source>Programmed means with the feed override of {:.4g} %.</source>
        <translation>« Programmé » veut dire avec la correction d’avance de {:.4g} %.</translation>
    </message>
    <message>
        <source>Speed and acceleration jump, which this model does not limit: the largest values are those between the jumps.</source>
        <translation>La vitesse et l’accélération sautent, ce que ce modèle ne limite pas&#xa0;: les valeurs maximales sont celles entre les sauts.</translation>
    </message>
    <message>
        <source>The contour tolerance of {} is {:.0f} % of the estimated chord error of the short lines ({}); Heidenhain advises 110 to 200 %.</source>
        <translation>La tolérance de contour de {} vaut {:.0f} % de l’erreur de corde estimée des lignes courtes ({})&#xa0;; Heidenhain conseille 110 à 200 %.</translation>
    </message>
    <message>
        <source>Line {} asks for a feed of {}; all axes of this machine together reach {}: what is lost against the programmed feed tells little there.</source>
        <translation>La ligne {} demande une avance de {}&#xa0;; tous les axes de cette machine ensemble atteignent {}&#xa0;: ce qui est perdu par rapport à l’avance programmée n’y dit pas grand-chose.</translation>
    </message>
    <message>
        <source>axis {} of the kinematic chain: {}</source>
        <translation>axe {} de la chaîne cinématique&#xa0;: {}</translation>
    </message>
    <message>
        <source>its direction has no length; give three numbers, such as 0, 0, 1</source>
        <translation>sa direction est de longueur nulle&#xa0;; donnez trois nombres, comme 0, 0, 1</translation>
    </message>
    <message>
        <source>its travel is empty, from {:g} to {:g}</source>
        <translation>sa course est vide, de {:g} à {:g}</translation>
    </message>
    <message>
        <source>it carries the part, but follows one that carries the tool; list those that carry the part first</source>
        <translation>il porte la pièce, mais suit un axe qui porte l’outil&#xa0;; donnez d’abord les axes qui portent la pièce</translation>
    </message>
    <message>
        <source>a kinematic chain needs three linear axes and has {}</source>
        <translation>une chaîne cinématique a besoin de trois axes linéaires et en a {}</translation>
    </message>
    <message>
        <source>the three linear axes of a kinematic chain lie in one plane</source>
        <translation>les trois axes linéaires d’une chaîne cinématique sont dans un même plan</translation>
    </message>
    <message>
        <source>a kinematic chain needs one or two rotary axes and has {}</source>
        <translation>une chaîne cinématique a besoin d’un ou deux axes rotatifs et en a {}</translation>
    </message>
    <message>
        <source>it is parallel to {}: together they turn the tool in one plane only</source>
        <translation>il est parallèle à {}&#xa0;: ensemble, ils ne tournent l’outil que dans un plan</translation>
    </message>
    <message>
        <source>it lies along the tool, which it does not turn</source>
        <translation>il est dans l’axe de l’outil, qu’il ne tourne donc pas</translation>
    </message>
    <message>
        <source>setting &apos;{}&apos; is unknown to the models {}; {}known settings: {}</source>
        <translation>le réglage «&#xa0;{}&#xa0;» est inconnu des modèles {}&#xa0;; {}réglages connus&#xa0;: {}</translation>
    </message>
    <message>
        <source>did you mean &apos;{}&apos;? </source>
        <translation>vouliez-vous dire «&#xa0;{}&#xa0;»&#xa0;? </translation>
    </message>
    <message>
        <source>&apos;{}&apos; is swept twice; write all its values into one sweep</source>
        <translation>«&#xa0;{}&#xa0;» est balayé deux fois&#xa0;; écrivez toutes ses valeurs dans un seul balayage</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is both swept and set to a value; omit &apos;{}&apos;</source>
        <translation>«&#xa0;{}&#xa0;» est à la fois balayé et fixé à une valeur&#xa0;; omettez «&#xa0;{}&#xa0;»</translation>
    </message>
    <message>
        <source>the tolerance is both swept and set; omit --tolerance</source>
        <translation>la tolérance est à la fois balayée et fixée&#xa0;; omettez --tolerance</translation>
    </message>
    <message>
        <source>sweep of &apos;{}&apos;: unknown to the models {}; {}known settings: {}</source>
        <translation>balayage de «&#xa0;{}&#xa0;»&#xa0;: inconnu des modèles {}&#xa0;; {}réglages connus&#xa0;: {}</translation>
    </message>
    <message>
        <source>cannot read lesson folder &apos;{}&apos;: {}</source>
        <translation>impossible de lire le dossier de leçons «&#xa0;{}&#xa0;»&#xa0;: {}</translation>
    </message>
    <message>
        <source>unknown lesson &apos;{}&apos;: no id and no file; {}</source>
        <translation>leçon «&#xa0;{}&#xa0;» inconnue&#xa0;: ni identifiant ni fichier&#xa0;; {}</translation>
    </message>
    <message>
        <source>numbers 1 to {}, or ids: {}</source>
        <translation>numéros 1 à {}, ou identifiants&#xa0;: {}</translation>
    </message>
    <message>
        <source>program &apos;{}&apos; of the lesson has an error on line {}: {}</source>
        <translation>le programme «&#xa0;{}&#xa0;» de la leçon a une erreur à la ligne {}&#xa0;: {}</translation>
    </message>
    <message>
        <source>{}: the second is 0, so there is no ratio</source>
        <translation>{}&#xa0;: la seconde valeur est 0, il n’y a donc pas de rapport</translation>
    </message>
    <message>
        <source>the text speaks of {}, which is in neither [numbers] nor [given]{}</source>
        <translation>le texte parle de {}, qui n’est ni dans [numbers] ni dans [given]{}</translation>
    </message>
    <message>
        <source>; did you mean {}?</source>
        <translation>&#xa0;; vouliez-vous dire {}&#xa0;?</translation>
    </message>
    <message>
        <source>nothing moves on {} of the program: no {} there</source>
        <translation>rien ne bouge en {} du programme&#xa0;: pas de «&#xa0;{}&#xa0;» là</translation>
    </message>
    <message>
        <source>the machine {} has no drives, so that there is no {}; give its axes kv_1_s</source>
        <translation>la machine {} n’a pas d’entraînements, donc pas de «&#xa0;{}&#xa0;»&#xa0;; donnez kv_1_s à ses axes</translation>
    </message>
    <message>
        <source>the model limits no jerk, so that the acceleration jumps: no {}</source>
        <translation>le modèle ne limite pas le jerk, l’accélération saute donc&#xa0;: pas de «&#xa0;{}&#xa0;»</translation>
    </message>
    <message>
        <source>unknown measure &apos;{}&apos;; {}</source>
        <translation>mesure «&#xa0;{}&#xa0;» inconnue&#xa0;; {}</translation>
    </message>
    <message>
        <source>unknown cause &apos;{}&apos;; {}</source>
        <translation>cause «&#xa0;{}&#xa0;» inconnue&#xa0;; {}</translation>
    </message>
    <message>
        <source>program &apos;{}&apos; is neither next to the lesson nor in {}{}</source>
        <translation>le programme «&#xa0;{}&#xa0;» n’est ni à côté de la leçon ni dans {}{}</translation>
    </message>
    <message>
        <source>; did you mean &apos;{}&apos;?</source>
        <translation>&#xa0;; vouliez-vous dire «&#xa0;{}&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>one number is expected here, not several</source>
        <translation>un seul nombre est attendu ici, pas plusieurs</translation>
    </message>
    <message>
        <source>is an SVG file, which this build of Feedscope cannot draw; use PNG or JPEG</source>
        <translation>est un fichier SVG, que cette version de Feedscope ne peut pas dessiner ; utilisez PNG ou JPEG</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ActionTable</name>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::AnnotationList</name>
    <message>
        <source>add %1</source>
        <translation>ajouter : %1</translation>
    </message>
    <message>
        <source>remove annotation</source>
        <translation>supprimer l’annotation</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::AnnotationOverlay</name>
    <message>
        <source>move annotation</source>
        <translation>déplacer l’annotation</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::AnnotationTable</name>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::AnnotationsView</name>
    <message>
        <source>Annotations</source>
        <translation>Annotations</translation>
    </message>
    <message>
        <source>Text of the annotation</source>
        <translation>Texte de l’annotation</translation>
    </message>
    <message>
        <source>Colour of the annotation</source>
        <translation>Couleur de l’annotation</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>text of annotation</source>
        <translation>texte de l’annotation</translation>
    </message>
    <message>
        <source>size of annotation</source>
        <translation>taille de l’annotation</translation>
    </message>
    <message>
        <source>Add &amp;text</source>
        <translation>Ajouter un &amp;texte</translation>
    </message>
    <message>
        <source>Place text beside the path at the cursor</source>
        <translation>Placer des mots à côté de la trajectoire, au curseur</translation>
    </message>
    <message>
        <source>Add &amp;arrow</source>
        <translation>Ajouter une &amp;flèche</translation>
    </message>
    <message>
        <source>Point an arrow at the cursor</source>
        <translation>Diriger une flèche vers l’endroit du curseur</translation>
    </message>
    <message>
        <source>Add &amp;callout</source>
        <translation>Ajouter une é&amp;tiquette</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Add &amp;dimension</source>
        <translation>Ajouter une &amp;cote</translation>
    </message>
    <message>
        <source>Add &amp;region</source>
        <translation>Ajouter une &amp;zone</translation>
    </message>
    <message>
        <source>&amp;Remove annotation</source>
        <translation>&amp;Supprimer l’annotation</translation>
    </message>
    <message>
        <source>Delete the selected annotation</source>
        <translation>Enlever l’annotation choisie</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open a program first: an annotation belongs to a place on its path.</source>
        <translation>Ouvrez d’abord un programme : une annotation se tient à un endroit de sa trajectoire.</translation>
    </message>
    <message>
        <source>%1 is not a value name; the tooltip of the text lists them.</source>
        <translation>%1 n’est pas une valeur ; l’infobulle du texte les énumère.</translation>
    </message>
    <message>
        <source>Click the path, then add an annotation there.</source>
        <translation>Cliquez la trajectoire, puis ajoutez ce qui doit y être dit.</translation>
    </message>
    <message>
        <source>Drag labels to move them; drag the dots of the selected one along the path.</source>
        <translation>Faites glisser les étiquettes pour les déplacer, et les points de celle qui est choisie le long de la trajectoire.</translation>
    </message>
    <message>
        <source>colour of annotation</source>
        <translation>couleur de l’annotation</translation>
    </message>
    <message>
        <source>Names in braces are replaced by the values at the place:</source>
        <translation>Les noms entre accolades sont remplacés par les valeurs à cet endroit&#xa0;:</translation>
    </message>
    <message>
        <source>Text size [points]</source>
        <translation>Taille du texte [points]</translation>
    </message>
    <message>
        <source>Place a label with feed, contour error and limiting cause at the cursor</source>
        <translation>Placer au curseur une étiquette avec avance, erreur de contour et cause limitante</translation>
    </message>
    <message>
        <source>Show the distance between cursors A and B of the charts, or between the ends of the visible range, or of the block at the cursor while the whole run is visible</source>
        <translation>Montrer la distance entre les curseurs A et B des graphiques, ou entre les bouts de la plage visible, ou celle du bloc au curseur tant que toute la simulation est visible</translation>
    </message>
    <message>
        <source>Mark the path between cursors A and B of the charts, or over the visible range, or the block at the cursor while the whole run is visible</source>
        <translation>Marquer la trajectoire entre les curseurs A et B des graphiques, ou sur la plage visible, ou le bloc au curseur tant que toute la simulation est visible</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CameraTrail</name>
    <message>
        <source>View &amp;before</source>
        <translation>Vue &amp;précédente</translation>
    </message>
    <message>
        <source>The 3D view as it was before the last jump to a place</source>
        <translation>La vue 3D comme avant le dernier saut à un endroit</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CauseStrip</name>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>+ %1</source>
        <translation>+ %1</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Limité par</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2 of the visible time, %3 s</source>
        <translation>%1&#xa0;: %2 du temps visible, %3&#xa0;s</translation>
    </message>
    <message>
        <source>%1 limited by</source>
        <comment>run</comment>
        <translation>%1 limité par</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ChartCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Tout afficher</translation>
    </message>
    <message>
        <source>Show the whole run and all values (double click)</source>
        <translation>Afficher toute la simulation et toutes les valeurs, comme un double-clic</translation>
    </message>
    <message>
        <source>Ctrl+Shift+0</source>
        <translation>Ctrl+Shift+0</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <source>Show the previous range and values</source>
        <translation>Afficher la plage et les valeurs précédentes</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>Show the next range and values</source>
        <translation>Afficher la plage et les valeurs suivantes</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom a&amp;vant</translation>
    </message>
    <message>
        <source>Zoom in around the cursor</source>
        <translation>La moitié de la plage, autour du curseur</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>Zoom out around the cursor</source>
        <translation>Le double de la plage, autour du curseur</translation>
    </message>
    <message>
        <source>Cursor &amp;left</source>
        <translation>Curseur à &amp;gauche</translation>
    </message>
    <message>
        <source>Move the cursor one pixel to the left</source>
        <translation>Déplacer le curseur d’un pixel à gauche</translation>
    </message>
    <message>
        <source>Cursor &amp;right</source>
        <translation>Curseur à &amp;droite</translation>
    </message>
    <message>
        <source>Move the cursor one pixel to the right</source>
        <translation>Déplacer le curseur d’un pixel à droite</translation>
    </message>
    <message>
        <source>Cursor far left</source>
        <translation>Curseur loin à gauche</translation>
    </message>
    <message>
        <source>Move the cursor ten pixels to the left</source>
        <translation>Déplacer le curseur de dix pixels à gauche</translation>
    </message>
    <message>
        <source>Shift+Left</source>
        <translation>Shift+Left</translation>
    </message>
    <message>
        <source>Cursor far right</source>
        <translation>Curseur loin à droite</translation>
    </message>
    <message>
        <source>Move the cursor ten pixels to the right</source>
        <translation>Déplacer le curseur de dix pixels à droite</translation>
    </message>
    <message>
        <source>Shift+Right</source>
        <translation>Shift+Right</translation>
    </message>
    <message>
        <source>Set cursor &amp;B</source>
        <translation>Poser le curseur &amp;B</translation>
    </message>
    <message>
        <source>Set a second cursor at the cursor and show the differences</source>
        <translation>Poser un second curseur à l’endroit du curseur et afficher les différences</translation>
    </message>
    <message>
        <source>Remove c&amp;ursor B</source>
        <translation>Enlever le c&amp;urseur B</translation>
    </message>
    <message>
        <source>Remove the second cursor (Esc)</source>
        <translation>Enlever le second curseur (Esc)</translation>
    </message>
    <message>
        <source>&amp;Zoom to A–B</source>
        <translation>&amp;Zoom sur A–B</translation>
    </message>
    <message>
        <source>Zoom to the range between the cursors</source>
        <translation>Zoomer sur la plage entre les curseurs</translation>
    </message>
    <message>
        <source>Over time or &amp;path length</source>
        <translation>Selon le temps ou la &amp;longueur</translation>
    </message>
    <message>
        <source>Horizontal axis of the charts</source>
        <translation>Axe horizontal des graphiques</translation>
    </message>
    <message>
        <source>Limiting &amp;causes</source>
        <translation>&amp;Causes limitantes</translation>
    </message>
    <message>
        <source>Show the limiting causes below the feed</source>
        <translation>Afficher les causes limitantes sous l’avance</translation>
    </message>
    <message>
        <source>Cur&amp;ves</source>
        <translation>C&amp;ourbes</translation>
    </message>
    <message>
        <source>Curves of &amp;other runs</source>
        <translation>Courbes d’&amp;autres simulations</translation>
    </message>
    <message>
        <source>Show or hide the curve [%1]</source>
        <translation>Afficher ou masquer la courbe [%1]</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Export visible range as C&amp;SV …</source>
        <translation>&amp;Exporter la plage visible en CSV …</translation>
    </message>
    <message>
        <source>Export the values of the visible range as a table</source>
        <translation>Exporter les valeurs de la plage visible sous forme de tableau</translation>
    </message>
    <message>
        <source>Export pict&amp;ure …</source>
        <translation>Exporter une i&amp;mage …</translation>
    </message>
    <message>
        <source>Export the charts as shown, as PNG or SVG</source>
        <translation>Exporter les graphiques tels quels, en PNG ou SVG</translation>
    </message>
    <message>
        <source>No run to export yet.</source>
        <translation>Il n’y a pas encore de simulation à exporter.</translation>
    </message>
    <message>
        <source>Export visible range</source>
        <translation>Exporter la plage visible</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exporter une image</translation>
    </message>
    <message>
        <source>Picture (*.png);;Drawing (*.svg)</source>
        <translation>Image (*.png);;Dessin (*.svg)</translation>
    </message>
    <message>
        <source>%1 has been written</source>
        <translation>%1 a été écrit</translation>
    </message>
    <message>
        <source>Feed, acceleration and jerk</source>
        <translation>Avance, accélération et jerk</translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation>%1 est encore en cours d’écriture.</translation>
    </message>
    <message>
        <source>C&amp;harts shown</source>
        <translation>Grap&amp;hiques affichés</translation>
    </message>
    <message>
        <source>Show or hide the chart, where the run has its values</source>
        <translation>Afficher ou masquer le graphique, si la simulation en a les valeurs</translation>
    </message>
    <message>
        <source>&amp;Rapids</source>
        <translation>&amp;Rapides</translation>
    </message>
    <message>
        <source>Show rapids here and in the 3D view</source>
        <translation>Afficher les rapides ici et dans la vue 3D</translation>
    </message>
    <message>
        <source>&amp;Zoom</source>
        <translation>&amp;Zoom</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Left</source>
        <translation>Ctrl+Alt+Left</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Right</source>
        <translation>Ctrl+Alt+Right</translation>
    </message>
    <message>
        <source>&amp;Cursor</source>
        <translation>&amp;Curseur</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ChartHeader</name>
    <message>
        <source>%1, %2 [%3]
Click: hide or show. Ctrl+click: only this one.</source>
        <translation>%1, %2 [%3]
Clic&#xa0;: masquer ou afficher. Ctrl+clic&#xa0;: celle-ci seule.</translation>
    </message>
    <message>
        <source>At the cursor: %1</source>
        <translation>Au curseur&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>feed, run</comment>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ChartsPanel</name>
    <message>
        <source>Time [s]</source>
        <translation>Temps [s]</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur de trajectoire</translation>
    </message>
    <message>
        <source>Chart commands</source>
        <translation>Commandes des graphiques</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CircularTable</name>
    <message>
        <source>ccw</source>
        <translation>trigo.</translation>
    </message>
    <message>
        <source>cw</source>
        <translation>horaire</translation>
    </message>
    <message>
        <source>First and last program line of the circle</source>
        <translation>Première et dernière ligne du cercle dans le programme</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Programmed centre: X, Y and Z of the tool centre</source>
        <translation>Centre programmé : X, Y et Z du centre de l’outil</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Programmed radius, and plane of the circle</source>
        <translation>Rayon programmé, et plan du cercle</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Avance programmée</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Largest feed on the circle</source>
        <translation>Plus grande avance sur le cercle</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>Atteinte</translation>
    </message>
    <message>
        <source>Counter-clockwise (ccw) or clockwise (cw), from the first axis of the plane</source>
        <translation>Sens trigonométrique (trigo.) ou horaire, à partir du premier axe du plan</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Circular error: least separation of two concentric circles that hold the path</source>
        <translation>Erreur de circularité : plus petit écart entre deux cercles concentriques qui contiennent la trajectoire</translation>
    </message>
    <message>
        <source>The same about the centre of the least-squares circle</source>
        <translation>La même autour du centre du cercle des moindres carrés</translation>
    </message>
    <message>
        <source>Largest deviation from the nominal radius at the programmed centre</source>
        <translation>Plus grand écart au rayon nominal autour du centre programmé</translation>
    </message>
    <message>
        <source>Least deviation from the nominal radius at the programmed centre</source>
        <translation>Plus petit écart au rayon nominal autour du centre programmé</translation>
    </message>
    <message>
        <source>Mean radius of this direction less the nominal one</source>
        <translation>Rayon moyen dans ce sens moins le rayon nominal</translation>
    </message>
    <message>
        <source>Circular error of both directions together</source>
        <translation>Erreur de circularité des deux sens réunis</translation>
    </message>
    <message>
        <source>Mean radius of both directions less the nominal one</source>
        <translation>Rayon moyen des deux sens moins le rayon nominal</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CircularView</name>
    <message>
        <source>Circular test</source>
        <translation>Essai circulaire</translation>
    </message>
    <message>
        <source>&amp;Entry arc</source>
        <translation>Arc d’&amp;entrée</translation>
    </message>
    <message>
        <source>Te&amp;st</source>
        <translation>&amp;Essai</translation>
    </message>
    <message>
        <source>A quarter circle leads in and one out, as in a bore; without it the circle runs from rest to rest</source>
        <translation>Un quart de cercle à l’entrée et un à la sortie, comme dans un alésage ; sans lui, le cercle va d’arrêt à arrêt</translation>
    </message>
    <message>
        <source>Radius of the quarter circles</source>
        <translation>Rayon des quarts de cercle</translation>
    </message>
    <message>
        <source>Plane of the circle</source>
        <translation>Plan du cercle</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Simulate the circle in both directions on this machine and control</source>
        <translation>Simuler le cercle dans les deux sens sur cette machine et cette commande</translation>
    </message>
    <message>
        <source>&amp;Circular test (ISO 230-4) …</source>
        <translation>Essai &amp;circulaire (ISO 230-4) …</translation>
    </message>
    <message>
        <source>Circularity and radial errors of a circle on this machine and control</source>
        <translation>Circularité et écarts radiaux d’un cercle sur cette machine et cette commande</translation>
    </message>
    <message>
        <source>Copy the values of the circular test</source>
        <translation>Copier les valeurs de l’essai circulaire</translation>
    </message>
    <message>
        <source>Copy circularity and radial errors to the clipboard</source>
        <translation>Copier la circularité et les écarts radiaux dans le presse-papiers</translation>
    </message>
    <message>
        <source>There is no circular test yet: press Test first.</source>
        <translation>Il n’y a pas encore d’essai circulaire : cliquez d’abord sur Essai.</translation>
    </message>
    <message>
        <source>Save the picture of the circular test …</source>
        <translation>Enregistrer l’image de l’essai circulaire …</translation>
    </message>
    <message>
        <source>The polar plot as PNG or SVG</source>
        <translation>Le diagramme polaire en PNG ou SVG</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Simulating …</source>
        <translation>Simulation …</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Circular test (ISO 230-4)</source>
        <translation>Essai circulaire (ISO 230-4)</translation>
    </message>
    <message>
        <source>%1, model %2</source>
        <translation>%1, modèle %2</translation>
    </message>
    <message>
        <source>Save the picture of the circular test</source>
        <translation>Enregistrer l’image de l’essai circulaire</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Images (*.png *.svg)</translation>
    </message>
    <message>
        <source>Circle to test</source>
        <translation>Cercle d’essai</translation>
    </message>
    <message>
        <source>Circles of the program</source>
        <translation>Cercles du programme</translation>
    </message>
    <message>
        <source>What is evaluated: circles of your choice, or the full circles of the program</source>
        <translation>Ce qui est évalué : des cercles de votre choix, ou les cercles complets du programme</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Radius of the circle; several with blanks between them make a table</source>
        <translation>Rayon du cercle ; plusieurs, séparés par des espaces, forment un tableau</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>Programmed feed; several with blanks between them make a table</source>
        <translation>Avance programmée ; plusieurs, séparées par des espaces, forment un tableau</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Avances</translation>
    </message>
    <message>
        <source>Values of the circular test</source>
        <translation>Valeurs de l’essai circulaire</translation>
    </message>
    <message>
        <source>Save the values of the circular test as CSV …</source>
        <translation>Enregistrer les valeurs de l’essai circulaire en CSV …</translation>
    </message>
    <message>
        <source>One row per circle and direction, with units</source>
        <translation>Une ligne par cercle et par sens, avec les unités</translation>
    </message>
    <message>
        <source>The full circles of the program are drawn here.</source>
        <translation>Les cercles complets du programme sont tracés ici.</translation>
    </message>
    <message>
        <source>A circle in both directions: choose radius and feed, then press Test.</source>
        <translation>Un cercle dans les deux sens : choisissez rayon et avance, puis cliquez sur Essai.</translation>
    </message>
    <message>
        <source>Open a program to see its full circles.</source>
        <translation>Ouvrez un programme pour voir ses cercles complets.</translation>
    </message>
    <message>
        <source>This run has not been simulated.</source>
        <translation>Cette simulation n’a pas été faite.</translation>
    </message>
    <message>
        <source>Evaluating the circles of the program …</source>
        <translation>Évaluation des cercles du programme …</translation>
    </message>
    <message>
        <source>Circle of the program (ISO 230-4)</source>
        <translation>Cercle du programme (ISO 230-4)</translation>
    </message>
    <message>
        <source>The program has no full circle to copy or save.</source>
        <translation>Il n’y a aucun cercle du programme à copier ou à enregistrer.</translation>
    </message>
    <message>
        <source>Save the circular test</source>
        <translation>Enregistrer l’essai circulaire</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Rechercher une commande</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CommandProcess</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 ne peut pas être lancé : %2</translation>
    </message>
    <message>
        <source>The command failed without a word (exit code %1).</source>
        <translation>La commande a échoué sans un mot (code de sortie %1).</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ComparisonChart</name>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>cycle time by limiting cause</source>
        <translation>temps de cycle par cause limitante</translation>
    </message>
    <message>
        <source>programmed time %1</source>
        <translation>temps programmé %1</translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation>%1, avec %2</translation>
    </message>
    <message>
        <source>path length %1</source>
        <translation>longueur de trajectoire %1</translation>
    </message>
    <message>
        <source>other causes</source>
        <translation>autres causes</translation>
    </message>
    <message>
        <source>programmed time</source>
        <translation>temps programmé</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>cycle time</source>
        <translation>temps de cycle</translation>
    </message>
    <message>
        <source>relative to</source>
        <translation>par rapport à</translation>
    </message>
    <message>
        <source>contour error</source>
        <translation>erreur de contour</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>hors de portée</translation>
    </message>
    <message>
        <source>refused lines</source>
        <translation>lignes refusées</translation>
    </message>
    <message>
        <source>without refused lines</source>
        <translation>sans les lignes refusées</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>actual contour error</source>
        <translation>erreur de contour réelle</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ContourChart</name>
    <message>
        <source>Histogram of the contour error</source>
        <translation>Histogramme de l’erreur de contour</translation>
    </message>
    <message>
        <source>%1 to %2 from the programmed path</source>
        <translation>De %1 à %2 de la trajectoire programmée</translation>
    </message>
    <message>
        <source>At most %1 left or right of the programmed path</source>
        <translation>Au plus %1 à gauche ou à droite de la trajectoire programmée</translation>
    </message>
    <message>
        <source>%1 to %2 left of the programmed path</source>
        <translation>De %1 à %2 à gauche de la trajectoire programmée</translation>
    </message>
    <message>
        <source>%1 to %2 right of the programmed path</source>
        <translation>De %1 à %2 à droite de la trajectoire programmée</translation>
    </message>
    <message>
        <source>%1: %2 of the path</source>
        <translation>%1&#xa0;: %2 de la trajectoire</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ContourPlacesModel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Rank by contour error</source>
        <translation>Rang par erreur de contour</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Distance of the executed path from the programmed one</source>
        <translation>Distance de la trajectoire exécutée à la trajectoire programmée</translation>
    </message>
    <message>
        <source>Share of the contour tolerance that applies there</source>
        <translation>Part de la tolérance de contour en vigueur à cet endroit</translation>
    </message>
    <message>
        <source>Used [%]</source>
        <translation>Utilisé [%]</translation>
    </message>
    <message>
        <source>Side of the programmed path in XY, in its direction: left is the G41 side</source>
        <translation>Côté de la trajectoire programmée dans XY, vu dans son sens&#xa0;: la gauche est là où G41 met l’outil</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Shape of the programmed path there</source>
        <translation>Ce qu’est la trajectoire programmée à cet endroit</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Achieved and programmed feed there</source>
        <translation>Avance atteinte et programmée à cet endroit</translation>
    </message>
    <message>
        <source>What limits the feed there</source>
        <translation>Ce qui limite l’avance à cet endroit</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Limité par</translation>
    </message>
    <message>
        <source>%1 from the programmed path at %2, X %3 Y %4 Z %5.</source>
        <translation>À %1 de la trajectoire programmée à %2, X %3 Y %4 Z %5.</translation>
    </message>
    <message>
        <source>The contour tolerance of %1 is exceeded here.</source>
        <translation>La tolérance de contour de %1 est dépassée ici.</translation>
    </message>
    <message>
        <source>The contour tolerance of %1 is kept here.</source>
        <translation>La tolérance de contour de %1 est tenue ici.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Program line and block number</source>
        <translation>Ligne du programme et numéro du bloc</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ContourView</name>
    <message>
        <source>&amp;Left and right</source>
        <translation>&amp;Gauche et droite</translation>
    </message>
    <message>
        <source>Close-&amp;up</source>
        <translation>Gros &amp;plan</translation>
    </message>
    <message>
        <source>Distinguish the sides of the path in XY; otherwise only the distance</source>
        <translation>Distinguer les côtés de la trajectoire dans XY&#xa0;; sinon la distance seule</translation>
    </message>
    <message>
        <source>Zoom the 3D view to the selected place</source>
        <translation>La vue 3D montre de près l’endroit choisi</translation>
    </message>
    <message>
        <source>Places farthest from the programmed path</source>
        <translation>Endroits les plus éloignés de la trajectoire programmée</translation>
    </message>
    <message>
        <source>Contour &amp;error …</source>
        <translation>&amp;Erreur de contour …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Copy the picture of the contour error</source>
        <translation>Copier l’image de l’erreur de contour</translation>
    </message>
    <message>
        <source>Copy the worst contour errors</source>
        <translation>Copier les plus grandes erreurs de contour</translation>
    </message>
    <message>
        <source>Save the worst contour errors as CSV …</source>
        <translation>Enregistrer les plus grandes erreurs de contour en CSV …</translation>
    </message>
    <message>
        <source>One row per place, with units</source>
        <translation>Une ligne par endroit, avec unités</translation>
    </message>
    <message>
        <source>Save the worst contour errors</source>
        <translation>Enregistrer les plus grandes erreurs de contour</translation>
    </message>
    <message>
        <source>Save the histogram of the contour error as CSV …</source>
        <translation>Enregistrer l’histogramme de l’erreur de contour en CSV …</translation>
    </message>
    <message>
        <source>Path length by contour error, one column per run, with units</source>
        <translation>Longueur de trajectoire par erreur de contour, une colonne par simulation, avec unités</translation>
    </message>
    <message>
        <source>Save the histogram of the contour error</source>
        <translation>Enregistrer l’histogramme de l’erreur de contour</translation>
    </message>
    <message>
        <source>Next contour error</source>
        <translation>Erreur de contour suivante</translation>
    </message>
    <message>
        <source>Go to the next listed place far from the programmed path</source>
        <translation>Aller au prochain endroit de la liste qui s’écarte de la trajectoire programmée</translation>
    </message>
    <message>
        <source>Previous contour error</source>
        <translation>Erreur de contour précédente</translation>
    </message>
    <message>
        <source>Go to the previous listed place</source>
        <translation>Revenir à l’endroit précédent de la liste</translation>
    </message>
    <message>
        <source>Open a program to see how far the executed path is from the programmed one.</source>
        <translation>De combien la trajectoire exécutée s’écarte de la trajectoire programmée&#xa0;: ouvrir un programme.</translation>
    </message>
    <message>
        <source>Comparing the executed with the programmed path …</source>
        <translation>Comparaison de la trajectoire exécutée avec la trajectoire programmée …</translation>
    </message>
    <message>
        <source>The program needs more memory than is available.</source>
        <translation>Le programme demande plus de mémoire qu’il n’y en a.</translation>
    </message>
    <message>
        <source>There is no contour error to save: open a program and this panel.</source>
        <translation>Il n’y a pas encore d’erreur de contour à enregistrer&#xa0;: ouvrir le panneau avec un programme.</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>This run has not been simulated.</source>
        <translation>Cette simulation n’a pas été faite.</translation>
    </message>
    <message>
        <source>Show how far and where the executed path deviates from the programmed one</source>
        <translation>Montrer de combien et où la trajectoire exécutée s’écarte de la trajectoire programmée</translation>
    </message>
    <message>
        <source>Copy the histogram to the clipboard</source>
        <translation>Copier l’histogramme dans le presse-papiers</translation>
    </message>
    <message>
        <source>Copy the list to the clipboard as CSV with units</source>
        <translation>Copier la liste dans le presse-papiers, en CSV avec unités</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Erreur de contour</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::CsvDialog</name>
    <message>
        <source>One row every</source>
        <translation>Une ligne toutes les</translation>
    </message>
    <message>
        <source>One row per pixel of the charts</source>
        <translation>Une ligne par pixel des courbes</translation>
    </message>
    <message>
        <source>Export visible range</source>
        <translation>Exporter la plage visible</translation>
    </message>
    <message>
        <source>From %1 s to %2 s</source>
        <translation>De %1 s à %2 s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Values between two pixels are not in the table</source>
        <translation>Ce qui se passe entre deux pixels n’est pas dans le tableau</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <source>One row at the start of each block</source>
        <translation>Une ligne au début de chaque bloc</translation>
    </message>
    <message>
        <source>Time between rows</source>
        <translation>Temps entre deux lignes</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::DecideView</name>
    <message>
        <source>This control has no contour tolerance; choose another one to compare tolerances</source>
        <translation>Cette commande n’a pas de tolérance de contour&#xa0;; en choisir une autre pour comparer des tolérances</translation>
    </message>
    <message>
        <source>Decide</source>
        <translation>Décider</translation>
    </message>
    <message>
        <source>Compare &amp;tolerances …</source>
        <translation>Comparer des &amp;tolérances …</translation>
    </message>
    <message>
        <source>Simulate the program with several contour tolerances and decide between them</source>
        <translation>Simuler le programme avec plusieurs tolérances de contour et décider entre elles</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Ma&amp;x. error</source>
        <translation>Erreur ma&amp;x.</translation>
    </message>
    <message>
        <source>compare runs variants decide</source>
        <translation>comparer simulations variantes décider</translation>
    </message>
    <message>
        <source>Runs and their results</source>
        <translation>Simulations et leurs résultats</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Ce qui ferait gagner du temps</translation>
    </message>
    <message>
        <source>Only runs with a contour error within this bound are recommended</source>
        <translation>Seules les simulations dont l’erreur de contour tient cette borne sont recommandées</translation>
    </message>
    <message>
        <source>compare runs</source>
        <translation>comparer des simulations</translation>
    </message>
    <message>
        <source>%1 of %2 runs are simulated; %3 were cancelled or failed.</source>
        <translation>%1 simulations sur %2 sont terminées ; %3 annulées ou en échec.</translation>
    </message>
    <message>
        <source>%1 of %2 runs are simulated.</source>
        <translation>%1 simulations calculées sur %2.</translation>
    </message>
    <message>
        <source>Open a program to see what its time is lost to.</source>
        <translation>Ouvrez un programme pour voir à quoi son temps se perd.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>Above the bound</source>
        <translation>Au-delà de la borne</translation>
    </message>
    <message>
        <source>%1.
Click to go to the worst place, in line %2.</source>
        <translation>%1.
Cliquer pour aller au pire endroit, ligne %2.</translation>
    </message>
    <message>
        <source>Where the time of %1 is lost</source>
        <translation>Où se perd le temps de %1</translation>
    </message>
    <message>
        <source>Where the time is lost</source>
        <translation>Où se perd le temps</translation>
    </message>
    <message>
        <source>Simulating what would help …</source>
        <translation>Simulation des remèdes …</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Make a run with this change</source>
        <translation>Créer une simulation avec ce changement</translation>
    </message>
    <message>
        <source>Try: %1</source>
        <translation>Essayer&#xa0;: %1</translation>
    </message>
    <message>
        <source>None of the changes that were simulated helps.</source>
        <translation>Aucun des changements simulés n’aide.</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Erreur %1</translation>
    </message>
    <message>
        <source>Programmed: %1, at the programmed feed.</source>
        <translation>Programmé&#xa0;: %1, à l’avance programmée.</translation>
    </message>
    <message>
        <source>Against
%1</source>
        <translation>Par rapport
à %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::DecisionChart</name>
    <message>
        <source>Cycle time over contour error</source>
        <translation>Temps de cycle selon l’erreur de contour</translation>
    </message>
    <message>
        <source>A dot is a run; the ringed one is recommended. Click to choose a run.</source>
        <translation>Un point est une simulation&#xa0;; celle cerclée est recommandée. Cliquer pour choisir une simulation.</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Erreur de contour</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>bound %1</source>
        <translation>borne %1</translation>
    </message>
    <message>
        <source>Actual contour error</source>
        <translation>Erreur de contour réelle</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::DiagnosticsModel</name>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Que faire</translation>
    </message>
    <message>
        <source>%1 (%2 more up to line %3)</source>
        <translation>%1 (%2 autres jusqu’à la ligne %3)</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::DiagnosticsView</name>
    <message>
        <source>Warnings and errors</source>
        <translation>Avertissements et erreurs</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Next message</source>
        <translation>Message suivant</translation>
    </message>
    <message>
        <source>Previous message</source>
        <translation>Message précédent</translation>
    </message>
    <message>
        <source>Go to the next message of the program</source>
        <translation>Aller au message suivant du programme</translation>
    </message>
    <message>
        <source>Go to the previous message</source>
        <translation>Aller au message précédent</translation>
    </message>
    <message>
        <source>Messages listed and visited by F8</source>
        <translation>Messages affichés dans la liste et parcourus par F8</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Tous les messages</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FeedShares</name>
    <message>
        <source>Share of time at each feed</source>
        <translation>Part du temps à chaque avance</translation>
    </message>
    <message>
        <source>%1 %2 and more: %3 % of the time shown</source>
        <translation>%1 %2 et plus : %3 % du temps affiché</translation>
    </message>
    <message>
        <source>%1 to %2 %3: %4 % of the time shown</source>
        <translation>%1 à %2 %3 : %4 % du temps affiché</translation>
    </message>
    <message>
        <source>time by feed
most: %1 %</source>
        <translation>temps/avance
max. : %1 %</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Quit Feedscope</source>
        <translation>Quitter Feedscope</translation>
    </message>
    <message>
        <source>&amp;Open program …</source>
        <translation>&amp;Ouvrir un programme …</translation>
    </message>
    <message>
        <source>Open an NC program or a session</source>
        <translation>Ouvrir un programme CN ou une session</translation>
    </message>
    <message>
        <source>Open &amp;sample …</source>
        <translation>Ouvrir un &amp;exemple …</translation>
    </message>
    <message>
        <source>Open one of the sample programs supplied with Feedscope</source>
        <translation>Ouvrir un des programmes d’exemple fournis avec Feedscope</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Programmes &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Reload program</source>
        <translation>Re&amp;charger le programme</translation>
    </message>
    <message>
        <source>Reload the program</source>
        <translation>Relire le programme</translation>
    </message>
    <message>
        <source>Reload when the file &amp;changes</source>
        <translation>Recharger &amp;si le fichier change</translation>
    </message>
    <message>
        <source>Reload the program whenever its file is written</source>
        <translation>Relire le programme chaque fois que son fichier est écrit</translation>
    </message>
    <message>
        <source>Program import &amp;options …</source>
        <translation>&amp;Options d’importation du programme …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Enregistrer la session</translation>
    </message>
    <message>
        <source>Save runs, views and annotations in one file</source>
        <translation>Garder simulations, vues et annotations dans un fichier</translation>
    </message>
    <message>
        <source>Save session &amp;as …</source>
        <translation>Enregistrer la session &amp;sous …</translation>
    </message>
    <message>
        <source>Save runs, views and annotations in another file</source>
        <translation>Garder simulations, vues et annotations dans un autre fichier</translation>
    </message>
    <message>
        <source>Open &amp;machine file …</source>
        <translation>Ouvrir un fichier &amp;machine …</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Save machine as …</source>
        <translation>Enregistrer la machine sous …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Save the machine with all changes as a machine file</source>
        <translation>Enregistrer la machine et toutes ses modifications dans un fichier machine</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>No program has been opened yet</source>
        <translation>Aucun programme ouvert jusqu’ici</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Vider la liste</translation>
    </message>
    <message>
        <source>Empty this list; the files are kept</source>
        <translation>Vider cette liste sans toucher aux fichiers</translation>
    </message>
    <message>
        <source>Open program or session</source>
        <translation>Ouvrir un programme ou une session</translation>
    </message>
    <message>
        <source>NC programs and sessions (*.feedscope *.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;All files (*)</source>
        <translation>Programmes CN et sessions (*.feedscope *.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open machine file</source>
        <translation>Ouvrir un fichier machine</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>Fichiers machine (*.toml)</translation>
    </message>
    <message>
        <source>Save machine as</source>
        <translation>Enregistrer la machine sous</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nom de la machine</translation>
    </message>
    <message>
        <source>Name shown in lists and reports:</source>
        <translation>Nom affiché dans les listes et les rapports&#xa0;:</translation>
    </message>
    <message>
        <source>Dialect of the program, cutter radii, limits of loops and calls</source>
        <translation>Dialecte du programme, rayons des fraises, limites des boucles et des appels</translation>
    </message>
    <message>
        <source>Open a machine file of your own, or the configuration of a control</source>
        <translation>Ouvrir un fichier machine personnel, ou la configuration d’une commande</translation>
    </message>
    <message>
        <source>Machine files and configurations of controls (*.toml *.ini *.cfg *.g *.txt *.tea *.mp);;All files (*)</source>
        <translation>Fichiers machine et configurations de commandes (*.toml *.ini *.cfg *.g *.txt *.tea *.mp);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Re&amp;port …</source>
        <translation>Ra&amp;pport …</translation>
    </message>
    <message>
        <source>Report as PDF or HTML, to print or to send, with a preview of its pages</source>
        <translation>Rapport en PDF ou HTML, à imprimer ou à envoyer, avec un aperçu de ses pages</translation>
    </message>
    <message>
        <source>print printer export paper document send</source>
        <translation>imprimer imprimante exporter papier document envoyer</translation>
    </message>
    <message>
        <source>export image screenshot print</source>
        <translation>exporter image capture imprimer</translation>
    </message>
    <message>
        <source>P&amp;icture …</source>
        <translation>&amp;Image …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Picture of a chosen size, with a preview: 3D view, charts, sheet or window, as PNG, SVG or PDF</source>
        <translation>Image de la taille choisie, avec un aperçu : vue 3D, graphiques, fiche ou fenêtre, en PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>export image screenshot print dpi poster</source>
        <translation>exporter image capture imprimer dpi affiche</translation>
    </message>
    <message>
        <source>P&amp;rint …</source>
        <translation>&amp;Imprimer …</translation>
    </message>
    <message>
        <source>Print the 3D view, charts, sheet, report, a hand-out or a table, with a preview</source>
        <translation>Imprimer la vue 3D, les courbes, la fiche, le rapport, un polycopié ou un tableau, avec un aperçu</translation>
    </message>
    <message>
        <source>printer paper hard copy</source>
        <translation>imprimante papier impression tirage</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Film of a stretch of the run: the 3D view with the moving tool, with charts below if wanted</source>
        <translation>Film d’une partie de la simulation : la vue 3D avec l’outil en mouvement, avec les graphiques dessous si souhaité</translation>
    </message>
    <message>
        <source>video movie animation export record</source>
        <translation>vidéo film animation exporter enregistrer</translation>
    </message>
    <message>
        <source>&amp;Film …</source>
        <translation>&amp;Film …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Ouvrir …</translation>
    </message>
    <message>
        <source>Rea&amp;ding</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Machine</translation>
    </message>
    <message>
        <source>Pi&amp;ctures</source>
        <translation>&amp;Images</translation>
    </message>
    <message>
        <source>Share as pa&amp;ge …</source>
        <translation>Partager en pa&amp;ge …</translation>
    </message>
    <message>
        <source>One file that opens in any browser: path in 3D, charts, decision and report, without network</source>
        <translation>Un fichier qui s’ouvre dans tout navigateur&#xa0;: trajectoire en 3D, graphiques, décision et rapport, sans réseau</translation>
    </message>
    <message>
        <source>web browser html send colleague customer tablet</source>
        <translation>web navigateur html envoyer collègue client tablette</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
    <message>
        <source>Share as page</source>
        <translation>Partager en page</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Page web (*.html)</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FileWriting</name>
    <message>
        <source>%1 has been written</source>
        <translation>%1 a été écrit</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Écriture de %1 …</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FilmDialog</name>
    <message>
        <source>C&amp;harts below, with a moving cursor</source>
        <translation>&amp;Graphiques dessous, avec un curseur mobile</translation>
    </message>
    <message>
        <source>&amp;Save film …</source>
        <translation>&amp;Enregistrer le film …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>How far back the line behind the tool reaches, in seconds of the run</source>
        <translation>Jusqu’où remonte le trait derrière l’outil, en secondes de la simulation</translation>
    </message>
    <message>
        <source>Seconds of the run in a second of the film; 1 is real time</source>
        <translation>Secondes de la simulation dans une seconde de film ; 1 est le temps réel</translation>
    </message>
    <message>
        <source>Pixels, such as 1920x1080</source>
        <translation>Pixels, par exemple 1920x1080</translation>
    </message>
    <message>
        <source>as in the window</source>
        <translation>comme dans la fenêtre</translation>
    </message>
    <message>
        <source>light</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>sombre</translation>
    </message>
    <message>
        <source>Video: one file, .ogv</source>
        <translation>Vidéo : un fichier .ogv</translation>
    </message>
    <message>
        <source>Series of pictures: PNG files in a folder</source>
        <translation>Suite d’images : fichiers PNG dans un dossier</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>Toute la si&amp;mulation</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Début</translation>
    </message>
    <message>
        <source>T&amp;o</source>
        <translation>&amp;Fin</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Frames a secon&amp;d</source>
        <translation>&amp;Images par seconde</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée du film</translation>
    </message>
    <message>
        <source>&amp;Trail</source>
        <translation>Traî&amp;née</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>Co&amp;uleurs</translation>
    </message>
    <message>
        <source>File for&amp;mat</source>
        <translation>F&amp;ormat du fichier</translation>
    </message>
    <message>
        <source>The film must end after it begins.</source>
        <translation>Le film doit finir après avoir commencé.</translation>
    </message>
    <message>
        <source>The size is a width and a height in pixels, such as 1280x720.</source>
        <translation>La taille est une largeur et une hauteur en pixels, par exemple 1280x720.</translation>
    </message>
    <message>
        <source>A video needs an even width and an even height.</source>
        <translation>Une vidéo demande une largeur et une hauteur paires.</translation>
    </message>
    <message>
        <source>%1 in %2 frames</source>
        <translation>%1 en %2 images</translation>
    </message>
    <message>
        <source>Save film</source>
        <translation>Enregistrer le film</translation>
    </message>
    <message>
        <source>Video (*.ogv)</source>
        <translation>Vidéo (*.ogv)</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Dossier des images</translation>
    </message>
    <message>
        <source>Cancelled; nothing has been written.</source>
        <translation>Arrêté ; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>As the cha&amp;rts show</source>
        <translation>Comme les gra&amp;phiques</translation>
    </message>
    <message>
        <source>%1 frames; at most %2 can be written. The speed must be %3 at least.</source>
        <translation>%1 images ; %2 au plus peuvent être écrites. Il faut une vitesse d’au moins %3.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FindBar</name>
    <message>
        <source>Aa</source>
        <translation>Aa</translation>
    </message>
    <message>
        <source>Match upper and lower case</source>
        <translation>Respecter la casse</translation>
    </message>
    <message>
        <source>W</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>Mots entiers seulement</translation>
    </message>
    <message>
        <source>.*</source>
        <translation>.*</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expression régulière</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Fermer (Esc)</translation>
    </message>
    <message>
        <source>Find in the program</source>
        <translation>Rechercher dans le programme</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>recherche …</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>introuvable</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>%1 trouvés</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>Résultat suivant (F3)</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>Résultat précédent (Shift+F3)</translation>
    </message>
    <message>
        <source>Search result</source>
        <translation>Résultat de la recherche</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::FitChoice</name>
    <message>
        <source>Limits and settings that the search begins with; those that are not looked for, or not found, stay</source>
        <translation>Limites et réglages de départ de la recherche&#xa0;; ceux qui ne sont pas cherchés, ou pas trouvés, restent</translation>
    </message>
    <message>
        <source>Control models that are fitted</source>
        <translation>Modèles de commande à ajuster</translation>
    </message>
    <message>
        <source>Numbers that are to be found</source>
        <translation>Nombres à trouver</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Begins with</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>&amp;Numbers to be found</source>
        <translation>&amp;Nombres à trouver</translation>
    </message>
    <message>
        <source>Usual ones</source>
        <translation>Habituels</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Tick no number</source>
        <translation>Ne cocher aucun nombre</translation>
    </message>
    <message>
        <source>Current run: %1</source>
        <translation>Simulation courante&#xa0;: %1</translation>
    </message>
    <message>
        <source>Run: %1</source>
        <translation>Simulation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Typical machine of each model</source>
        <translation>Machine typique de chaque modèle</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Begin with machine</source>
        <translation>Mac&amp;hine de départ</translation>
    </message>
    <message>
        <source>Control mo&amp;dels: tick several to see which one explains the recording best</source>
        <translation>Mo&amp;dèles de commande&#xa0;: en cocher plusieurs pour voir lequel explique le mieux l’enregistrement</translation>
    </message>
    <message>
        <source>Tick the limits of the axes, the settings with a unit, and the drives whose set and actual positions are recorded</source>
        <translation>Cocher les limites des axes, les réglages qui ont une unité et les entraînements dont la consigne et la position réelle sont enregistrées</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::GoToBar</name>
    <message>
        <source>Line to go to</source>
        <translation>Ligne à atteindre</translation>
    </message>
    <message>
        <source>Line to go to (Enter)</source>
        <translation>Ligne à atteindre (Enter)</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::HandbookWindow</name>
    <message>
        <source>Feedscope handbook</source>
        <translation>Manuel de Feedscope</translation>
    </message>
    <message>
        <source>Search the handbook</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Lists the pages that contain all words; Enter goes to the next match</source>
        <translation>Affiche les pages qui contiennent tous les mots&#xa0;; Entrée va à l’endroit suivant</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::HandoutCommand</name>
    <message>
        <source>print paper class lesson worksheet exercise</source>
        <translation>imprimer papier classe cours leçon polycopié exercice</translation>
    </message>
    <message>
        <source>Save hand-out as</source>
        <translation>Enregistrer le polycopié sous</translation>
    </message>
    <message>
        <source>Hand-outs (*.pdf *.html)</source>
        <translation>Polycopiés (*.pdf *.html)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
    <message>
        <source>Hand-out for &amp;learners …</source>
        <translation>Polycopié pour les &amp;apprenants …</translation>
    </message>
    <message>
        <source>Questions of the open lesson with room to write, no answers, as PDF or HTML</source>
        <translation>Questions de la leçon ouverte avec de la place pour écrire, sans réponses, en PDF ou HTML</translation>
    </message>
    <message>
        <source>Hand-out for the &amp;teacher …</source>
        <translation>Polycopié pour l’&amp;enseignant …</translation>
    </message>
    <message>
        <source>Questions and answers of the open lesson with the numbers they build on, as PDF or HTML</source>
        <translation>Questions et réponses de la leçon ouverte avec les valeurs sur lesquelles elles reposent, en PDF ou HTML</translation>
    </message>
    <message>
        <source>Hand-out for &amp;everybody …</source>
        <translation>Polycopié pour &amp;tous …</translation>
    </message>
    <message>
        <source>Questions of the open lesson, and answers on pages of their own, as PDF or HTML</source>
        <translation>Questions de la leçon ouverte, et réponses sur des pages à part, en PDF ou HTML</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Hand&amp;book</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>First steps, panels, commands</source>
        <translation>Premiers pas, panneaux, commandes</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Leçons</translation>
    </message>
    <message>
        <source>Lessons for courses, with questions on the simulation</source>
        <translation>Leçons pour les cours, avec des questions sur la simulation</translation>
    </message>
    <message>
        <source>&amp;Find a command …</source>
        <translation>&amp;Rechercher une commande …</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Find a command by typing part of its name</source>
        <translation>Trouver une commande en saisissant une partie de son nom</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Clavier et souris</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>All keyboard shortcuts and mouse actions</source>
        <translation>Tous les raccourcis clavier et actions de la souris</translation>
    </message>
    <message>
        <source>help manual documentation how to</source>
        <translation>aide manuel documentation comment</translation>
    </message>
    <message>
        <source>&amp;About Feedscope</source>
        <translation>À &amp;propos de Feedscope</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version et licence</translation>
    </message>
    <message>
        <source>About Feedscope</source>
        <translation>À propos de Feedscope</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Feedscope %1&lt;/h3&gt;&lt;p&gt;Shows what a CNC control does with an NC program: path, feed, acceleration and jerk, and what limits the feed.&lt;/p&gt;&lt;p&gt;Models of published controls on published machines. How far to trust a number: &lt;i&gt;Help › Handbook&lt;/i&gt;, &lt;i&gt;Models and accuracy&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;The source is BSD 3-clause. This program links Qt Charts and is distributed under the GPL 3. With Qt %2, VTK and the DejaVu fonts.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Feedscope %1&lt;/h3&gt;&lt;p&gt;Montre ce qu’une commande CNC fait d’un programme : trajectoire, avance, accélération et jerk, et ce qui limite l’avance.&lt;/p&gt;&lt;p&gt;Modèles de commandes publiées sur des machines publiées. Jusqu’où croire un nombre : &lt;i&gt;Aide › Manuel&lt;/i&gt;, &lt;i&gt;Modèles et précision&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Les sources sont sous licence BSD à 3 clauses. Ce programme est lié à Qt Charts et distribué sous GPL 3. Avec Qt %2, VTK et les polices DejaVu.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Page d’&amp;accueil</translation>
    </message>
    <message>
        <source>Samples, recent programs, lessons, what to do first</source>
        <translation>Exemples, programmes récents, leçons, par où commencer</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::IdentificationJob</name>
    <message>
        <source>Laying the recordings beside the program</source>
        <translation>Mise en correspondance des enregistrements et du programme</translation>
    </message>
    <message>
        <source>Searching: %1</source>
        <translation>Recherche&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1, model %2 of %3. %4</source>
        <translation>%1, modèle %2 sur %3. %4</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::IdentificationView</name>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>&amp;Identify</source>
        <translation>&amp;Identifier</translation>
    </message>
    <message>
        <source>Search the numbers with which each model explains the recordings best; Esc cancels</source>
        <translation>Chercher les nombres avec lesquels chaque modèle explique le mieux les enregistrements&#xa0;; Échap annule</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>&amp;Identify the machine …</source>
        <translation>&amp;Identifier la machine …</translation>
    </message>
    <message>
        <source>Limits and settings of your machine from what it recorded, and which control it is like</source>
        <translation>Limites et réglages de votre machine d’après ce qu’elle a enregistré, et à quelle commande elle ressemble</translation>
    </message>
    <message>
        <source>identify machine parameters trace calibrate fit my own limits measured</source>
        <translation>identifier identification machine paramètres trace calibrer recaler limites mesurées ma propre</translation>
    </message>
    <message>
        <source>Trace …</source>
        <translation>Trace …</translation>
    </message>
    <message>
        <source>What the control recorded while the program ran</source>
        <translation>Ce que la commande a enregistré pendant le programme</translation>
    </message>
    <message>
        <source>Open section times …</source>
        <translation>Ouvrir des temps de sections …</translation>
    </message>
    <message>
        <source>A table of the times of sections, for those without a trace: section,seconds</source>
        <translation>Un tableau des temps de sections, quand il n’y a pas de trace&#xa0;: section,seconds</translation>
    </message>
    <message>
        <source>Section times …</source>
        <translation>Temps de sections …</translation>
    </message>
    <message>
        <source>identify machine parameters stopwatch times table</source>
        <translation>identifier machine paramètres chronomètre temps tableau</translation>
    </message>
    <message>
        <source>Write a test program …</source>
        <translation>Écrire un programme d’essai …</translation>
    </message>
    <message>
        <source>The program whose recording tells most limits of a machine</source>
        <translation>Le programme dont l’enregistrement révèle le plus de limites d’une machine</translation>
    </message>
    <message>
        <source>Test program …</source>
        <translation>Programme d’essai …</translation>
    </message>
    <message>
        <source>identify machine parameters trace measure corners circles</source>
        <translation>identifier machine paramètres trace mesurer angles cercles</translation>
    </message>
    <message>
        <source>Show the identified machine as a run</source>
        <translation>Montrer la machine identifiée comme simulation</translation>
    </message>
    <message>
        <source>A run on the machine that was found; its curves lie over the trace</source>
        <translation>Une simulation sur la machine trouvée&#xa0;; ses courbes se superposent à la trace</translation>
    </message>
    <message>
        <source>Show as run</source>
        <translation>Montrer comme simulation</translation>
    </message>
    <message>
        <source>Save the identified machine …</source>
        <translation>Enregistrer la machine identifiée …</translation>
    </message>
    <message>
        <source>The machine that was found as a machine file, each number with its source</source>
        <translation>La machine trouvée en fichier machine, chaque nombre avec sa source</translation>
    </message>
    <message>
        <source>Save machine file …</source>
        <translation>Enregistrer la machine …</translation>
    </message>
    <message>
        <source>What was recorded</source>
        <translation>Ce qui a été enregistré</translation>
    </message>
    <message>
        <source>What is fitted to it</source>
        <translation>Ce qui y est ajusté</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>Open the program that was recorded first.</source>
        <translation>Ouvrir d’abord le programme qui a été enregistré.</translation>
    </message>
    <message>
        <source>The trace is being read …</source>
        <translation>Lecture de la trace …</translation>
    </message>
    <message>
        <source>Step 1: open a trace or a table of section times.</source>
        <translation>Étape 1&#xa0;: ouvrir une trace ou un tableau de temps de sections.</translation>
    </message>
    <message>
        <source>Step 2: tick a control model.</source>
        <translation>Étape 2&#xa0;: cocher un modèle de commande.</translation>
    </message>
    <message>
        <source>Step 2: tick a number to be found.</source>
        <translation>Étape 2&#xa0;: cocher un nombre à trouver.</translation>
    </message>
    <message>
        <source>Done after %1 simulations of the program.</source>
        <translation>Terminé après %1 simulations du programme.</translation>
    </message>
    <message>
        <source>Identified from %1</source>
        <translation>Identifiée d’après %1</translation>
    </message>
    <message>
        <source>Save the machine</source>
        <translation>Enregistrer la machine</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>Fichiers machine (*.toml)</translation>
    </message>
    <message>
        <source>%1 is written; it is offered wherever a machine is chosen.</source>
        <translation>%1 est écrit&#xa0;; il est proposé partout où une machine se choisit.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Open table of section times</source>
        <translation>Ouvrir un tableau de temps de sections</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tableaux (*.csv *.tsv *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1, identified</source>
        <translation>%1, identifiée</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::JobBase</name>
    <message>
        <source>The program needs more memory than is available.</source>
        <translation>Le programme demande plus de mémoire qu’il n’y en a.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::KeyList</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>&lt;b&gt;3D view:&lt;/b&gt; left drag rotates, Shift+drag or middle drag pans, wheel or right drag zooms, a click sets the cursor.&lt;br&gt;&lt;b&gt;Charts:&lt;/b&gt; wheel zooms at the pointer, drag pans, a click sets the cursor, a double click shows all.&lt;br&gt;&lt;b&gt;Program:&lt;/b&gt; a click on a line sets the cursor there.</source>
        <translation>&lt;b&gt;Vue 3D&#xa0;:&lt;/b&gt; glisser au bouton gauche tourne, avec Shift ou au bouton du milieu déplace, la molette ou glisser au bouton droit zoome, un clic place le curseur.&lt;br&gt;&lt;b&gt;Graphiques&#xa0;:&lt;/b&gt; la molette zoome au pointeur, glisser déplace, un clic place le curseur, un double-clic montre tout.&lt;br&gt;&lt;b&gt;Programme&#xa0;:&lt;/b&gt; un clic sur une ligne y place le curseur.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::KinematicChart</name>
    <message>
        <source>Click: cursor. Shift+click: second cursor, differences. Wheel: zoom. Drag: pan.
Right drag or Ctrl+drag: zoom to a box. Ctrl+wheel: zoom the values. Double click: show all.</source>
        <translation>Clic&#xa0;: curseur. Shift+clic&#xa0;: second curseur, différences. Molette&#xa0;: zoom. Glisser&#xa0;: déplacer.
Glisser au bouton droit ou Ctrl+glisser&#xa0;: zoom sur une zone. Ctrl+molette&#xa0;: zoom des valeurs. Double-clic&#xa0;: tout afficher.</translation>
    </message>
    <message>
        <source>▴ rapids up to %1</source>
        <translation>▴ rapides jusqu’à %1</translation>
    </message>
    <message>
        <source>line: mean of the columns</source>
        <translation>trait : moyenne des colonnes</translation>
    </message>
    <message>
        <source>bands: 5 to 95 % of the time, pale: extremes</source>
        <translation>bandes : 5 à 95 % du temps, pâle : extrêmes</translation>
    </message>
    <message>
        <source>line: mean feed</source>
        <translation>trait : avance moyenne</translation>
    </message>
    <message>
        <source>jumps of the acceleration are not drawn</source>
        <translation>sauts de l’accélération non tracés</translation>
    </message>
    <message>
        <source>▴ programmed up to %1</source>
        <translation>▴ programmée jusqu’à %1</translation>
    </message>
    <message>
        <source>▴ peaks up to %1</source>
        <translation>▴ pointes jusqu’à %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LensOverlay</name>
    <message>
        <source>&amp;Lens at the cursor</source>
        <translation>&amp;Loupe au curseur</translation>
    </message>
    <message>
        <source>What the ticked runs do at the cursor, over each other, stretched across the path</source>
        <translation>Ce que font les simulations cochées au curseur, l’une sur l’autre, étirées en travers de la trajectoire</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>The ticked runs at the cursor; click to enlarge</source>
        <translation>Les simulations cochées au curseur ; cliquer pour agrandir</translation>
    </message>
    <message>
        <source>Lens at the cursor</source>
        <translation>Loupe au curseur</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LessonDesk</name>
    <message>
        <source>clear the values tried</source>
        <translation>effacement des valeurs essayées</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LessonMenu</name>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Leçons</translation>
    </message>
    <message>
        <source>&amp;This lesson</source>
        <translation>&amp;Cette leçon</translation>
    </message>
    <message>
        <source>&amp;Hand-outs</source>
        <translation>&amp;Documents à distribuer</translation>
    </message>
    <message>
        <source>Half a &amp;day</source>
        <translation>&amp;Demi-journée</translation>
    </message>
    <message>
        <source>T&amp;wo days</source>
        <translation>De&amp;ux jours</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LessonView</name>
    <message>
        <source>A course of half a day: %1. Of two days: all.</source>
        <translation>Un cours d’une demi-journée&#xa0;: %1. De deux jours&#xa0;: toutes.</translation>
    </message>
    <message>
        <source>Before you look</source>
        <translation>Avant de regarder</translation>
    </message>
    <message>
        <source>On my control</source>
        <translation>Sur ma commande</translation>
    </message>
    <message>
        <source>Text of the lesson</source>
        <translation>Texte de la leçon</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>Set up the window</source>
        <translation>Préparer la fenêtre</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>Question précédente</translation>
    </message>
    <message>
        <source>Next question</source>
        <translation>Question suivante</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Show or hide the hint of the question</source>
        <translation>Montrer ou cacher l’indice de la question</translation>
    </message>
    <message>
        <source>Show answer</source>
        <translation>Montrer la réponse</translation>
    </message>
    <message>
        <source>%1. %2 (%3 min)</source>
        <translation>%1. %2 (%3 min)</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Question %1 sur %2</translation>
    </message>
    <message>
        <source>Hint:</source>
        <translation>Indice :</translation>
    </message>
    <message>
        <source>Answer:</source>
        <translation>Réponse :</translation>
    </message>
    <message>
        <source>In the current run: %1 &lt;b&gt;%2&lt;/b&gt;</source>
        <translation>Dans la simulation courante : %1 &lt;b&gt;%2&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Show the setting in the tables of axis limits and control settings</source>
        <translation>Montrer le réglage dans les tables des limites d’axes et des réglages</translation>
    </message>
    <message>
        <source>Open the program of the lesson with its machine, settings and view; this replaces the runs</source>
        <translation>Ouvrir le programme de la leçon avec sa machine, ses réglages et sa vue&#xa0;; les simulations sont remplacées</translation>
    </message>
    <message>
        <source>Go to the previous question</source>
        <translation>Aller à la question précédente</translation>
    </message>
    <message>
        <source>Go to the next question</source>
        <translation>Aller à la question suivante</translation>
    </message>
    <message>
        <source>Show or hide the answer to the question</source>
        <translation>Montrer ou cacher la réponse à la question</translation>
    </message>
    <message>
        <source>Set %1 to this value in the current run</source>
        <translation>Donner cette valeur à %1 dans la simulation courante</translation>
    </message>
    <message>
        <source>Show setting</source>
        <translation>Montrer le réglage</translation>
    </message>
    <message>
        <source>Vary &lt;b&gt;%1&lt;/b&gt; between</source>
        <translation>Faire varier &lt;b&gt;%1&lt;/b&gt; entre</translation>
    </message>
    <message>
        <source>Set &lt;b&gt;%1&lt;/b&gt; to</source>
        <translation>Mettre &lt;b&gt;%1&lt;/b&gt; à</translation>
    </message>
    <message>
        <source>Back to my own</source>
        <translation>Revenir à mon travail</translation>
    </message>
    <message>
        <source>Bring back the program, runs, settings and view that were in the window before the lesson</source>
        <translation>Rendre le programme, les simulations, les réglages et la vue qui étaient dans la fenêtre avant la leçon</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Expected answer</source>
        <translation>Réponse attendue</translation>
    </message>
    <message>
        <source>Your own answer</source>
        <translation>Votre propre réponse</translation>
    </message>
    <message>
        <source>Your own answer, kept with the session</source>
        <translation>Votre propre réponse, gardée avec la session</translation>
    </message>
    <message>
        <source>Another value</source>
        <translation>Autre valeur</translation>
    </message>
    <message>
        <source>Type another value to try</source>
        <translation>Saisir une autre valeur à essayer</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Set this value in the current run</source>
        <translation>Donner cette valeur à la simulation courante</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Toutes les leçons</translation>
    </message>
    <message>
        <source>Show the list of lessons</source>
        <translation>Montrer la liste des leçons</translation>
    </message>
    <message>
        <source>Copy the values tried</source>
        <translation>Copier les valeurs essayées</translation>
    </message>
    <message>
        <source>Copy the values tried at this question, for a text or a spreadsheet</source>
        <translation>Copier les valeurs essayées à cette question, pour un texte ou un tableur</translation>
    </message>
    <message>
        <source>Copy the values tried as CSV</source>
        <translation>Copier les valeurs essayées en CSV</translation>
    </message>
    <message>
        <source>Copy the values tried at this question as CSV, with decimal points</source>
        <translation>Copier les valeurs essayées à cette question en CSV, avec des points décimaux</translation>
    </message>
    <message>
        <source>Clear the values tried</source>
        <translation>Effacer les valeurs essayées</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Forget the values tried at this question; the answer stays. Edit &gt; Undo brings them back</source>
        <translation>Oublier les valeurs essayées à cette question&#xa0;; la réponse reste. Édition &gt; Annuler les rétablit</translation>
    </message>
    <message>
        <source>Show the run</source>
        <translation>Montrer la simulation</translation>
    </message>
    <message>
        <source>Runs without a prediction</source>
        <translation>Simulations sans prédiction</translation>
    </message>
    <message>
        <source>For teachers: show the run of a lesson before a prediction is written</source>
        <translation>Pour l’enseignant : montrer la simulation d’une leçon avant qu’une prédiction soit écrite</translation>
    </message>
    <message>
        <source>Your prediction</source>
        <translation>Votre prédiction</translation>
    </message>
    <message>
        <source>What you expect, kept with the session; it cannot be changed afterwards</source>
        <translation>Ce que vous attendez, gardé avec la session ; cela ne se change plus ensuite</translation>
    </message>
    <message>
        <source>Write the prediction down and set up the window with the lesson</source>
        <translation>Noter la prédiction et préparer la fenêtre avec la leçon</translation>
    </message>
    <message>
        <source>Your prediction:</source>
        <translation>Votre prédiction :</translation>
    </message>
    <message>
        <source>Complete the sentence; kept with the session and printed on the hand-out</source>
        <translation>Complétez la phrase ; elle est gardée avec la session et imprimée sur le polycopié</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>Go on to the question</source>
        <translation>Passer à la question</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LoadFiguresTable</name>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>At the feed that the control reaches</source>
        <translation>À l’avance que la commande atteint</translation>
    </message>
    <message>
        <source>In line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Where the load is the largest; a click goes there</source>
        <translation>Là où la charge est la plus grande&#xa0;; un clic y mène</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Over the time of cutting</source>
        <translation>Sur le temps de coupe</translation>
    </message>
    <message>
        <source>Programmed, largest</source>
        <translation>Programmée, maximum</translation>
    </message>
    <message>
        <source>If the tool ran at the programmed feed everywhere</source>
        <translation>Si l’outil avançait partout à l’avance programmée</translation>
    </message>
    <message>
        <source>Programmed, mean</source>
        <translation>Programmée, moyenne</translation>
    </message>
    <message>
        <source>Over the time that this would take</source>
        <translation>Sur le temps que cela prendrait</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LoadPlacesTable</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Beyond a bound</source>
        <translation>Au-delà d’une borne</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Pire</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LoadView</name>
    <message>
        <source>Cutting load</source>
        <translation>Charge de coupe</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Places beyond a bound</source>
        <translation>Endroits au-delà d’une borne</translation>
    </message>
    <message>
        <source>Operation whose load is listed</source>
        <translation>Opération dont la charge est affichée</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Cutting &amp;load …</source>
        <translation>Char&amp;ge de coupe …</translation>
    </message>
    <message>
        <source>Chip thickness, cutting force, torque and power of the run</source>
        <translation>Épaisseur de copeau, effort de coupe, couple et puissance de la simulation</translation>
    </message>
    <message>
        <source>Add operation</source>
        <translation>Ajouter une opération</translation>
    </message>
    <message>
        <source>Another tool, or lines on which it is engaged otherwise</source>
        <translation>Un autre outil, ou des lignes où il est engagé autrement</translation>
    </message>
    <message>
        <source>Remove operation</source>
        <translation>Supprimer l’opération</translation>
    </message>
    <message>
        <source>Remove the selected operation</source>
        <translation>Supprimer l’opération sélectionnée</translation>
    </message>
    <message>
        <source>Open load file …</source>
        <translation>Ouvrir un fichier de charge …</translation>
    </message>
    <message>
        <source>Operations and materials of a file</source>
        <translation>Opérations et matériaux d’un fichier</translation>
    </message>
    <message>
        <source>Save load file …</source>
        <translation>Enregistrer le fichier de charge …</translation>
    </message>
    <message>
        <source>Operations and materials, for other programs and the command line</source>
        <translation>Opérations et matériaux, pour d’autres programmes et la ligne de commande</translation>
    </message>
    <message>
        <source>cutting load</source>
        <translation>charge de coupe</translation>
    </message>
    <message>
        <source>All operations</source>
        <translation>Toutes les opérations</translation>
    </message>
    <message>
        <source>Say how the tools of the program are engaged: the load then follows from the feed that the control reaches, beside that of the programmed feed.</source>
        <translation>Indiquez comment les outils du programme sont engagés&#xa0;: la charge découle alors de l’avance que la commande atteint, à côté de celle de l’avance programmée.</translation>
    </message>
    <message>
        <source>No program yet.</source>
        <translation>Pas encore de programme.</translation>
    </message>
    <message>
        <source>The run is being simulated.</source>
        <translation>La simulation est en cours.</translation>
    </message>
    <message>
        <source>No operation to save: add one first.</source>
        <translation>Aucune opération à enregistrer&#xa0;: en ajouter une d’abord.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut pas être écrit&#xa0;: %2</translation>
    </message>
    <message>
        <source>Open load file</source>
        <translation>Ouvrir un fichier de charge</translation>
    </message>
    <message>
        <source>Load files (*.toml)</source>
        <translation>Fichiers de charge (*.toml)</translation>
    </message>
    <message>
        <source>Save load file</source>
        <translation>Enregistrer le fichier de charge</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::LostTimeChart</name>
    <message>
        <source>Time lost against other runs</source>
        <translation>Temps perdu sur les autres simulations</translation>
    </message>
    <message>
        <source>Time that the current run has lost against the others since the start, at the same place of the path; below 0 it is ahead</source>
        <translation>Temps que la simulation courante a perdu sur les autres depuis le début, au même endroit de la trajectoire ; sous 0, elle est en avance</translation>
    </message>
    <message>
        <source>Time lost against</source>
        <translation>Temps perdu sur</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::MachineOpening</name>
    <message>
        <source>Import machine</source>
        <translation>Importer une machine</translation>
    </message>
    <message>
        <source>%1 is the configuration of a control: %2.
Use the machine that it describes for the current run?</source>
        <translation>%1 est la configuration d’une commande : %2.
Utiliser la machine qu’elle décrit pour la simulation courante ?</translation>
    </message>
    <message>
        <source>Numbers from the file: %1, assumed: %2.</source>
        <translation>Nombres du fichier : %1, supposés : %2.</translation>
    </message>
    <message>
        <source>Notes: %1.</source>
        <translation>Remarques : %1.</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>Machine imported from %1. File &gt; Machine &gt; Save machine as … keeps it as a machine file.</source>
        <translation>Machine importée de %1. Fichier &gt; Machine &gt; Enregistrer la machine sous … la garde comme fichier machine.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::MainWindow</name>
    <message>
        <source>Feedscope</source>
        <translation>Feedscope</translation>
    </message>
    <message>
        <source>%1 – Feedscope</source>
        <translation>%1 – Feedscope</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>&amp;Runs</source>
        <translation>&amp;Simulations</translation>
    </message>
    <message>
        <source>&amp;Cancel simulation</source>
        <translation>&amp;Arrêter la simulation</translation>
    </message>
    <message>
        <source>Stop reading, simulating or comparing runs</source>
        <translation>Arrêter la lecture, la simulation ou la comparaison</translation>
    </message>
    <message>
        <source>&amp;Charts</source>
        <translation>&amp;Graphiques</translation>
    </message>
    <message>
        <source>&amp;Why here?</source>
        <translation>&amp;Pourquoi ici&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>Alle&amp;r</translation>
    </message>
    <message>
        <source>Undo the last change of runs and settings</source>
        <translation>Annuler la dernière modification des simulations et des réglages</translation>
    </message>
    <message>
        <source>Redo the change that was undone</source>
        <translation>Refaire la modification annulée</translation>
    </message>
    <message>
        <source>&amp;Annotations</source>
        <translation>A&amp;nnotations</translation>
    </message>
    <message>
        <source>A&amp;nalysis</source>
        <translation>A&amp;nalyse</translation>
    </message>
    <message>
        <source>The run is shown once a prediction is written in the lesson.</source>
        <translation>La simulation est montrée une fois qu’une prédiction est écrite dans la leçon.</translation>
    </message>
    <message>
        <source>The program is shown with the run, after the prediction.</source>
        <translation>Le programme est montré avec la simulation, après la prédiction.</translation>
    </message>
    <message>
        <source>Measuring the numbers of the lesson …</source>
        <translation>Mesure des valeurs de la leçon …</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::NumberBox</name>
    <message>
        <source>“%1” is not between %2 and %3.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas entre %2 et %3.</translation>
    </message>
    <message>
        <source>“%1” has too many decimals; the smallest step is %2.</source>
        <translation>«&#xa0;%1&#xa0;» a trop de décimales&#xa0;; le plus petit pas est %2.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::NumberListField</name>
    <message>
        <source>Type one number or several with blanks between them.</source>
        <translation>Saisissez un nombre, ou plusieurs séparés par des espaces.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::OperationTable</name>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Diameter of the tool, a cylindrical end mill</source>
        <translation>Diamètre de l’outil, une fraise cylindrique</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>Hélice</translation>
    </message>
    <message>
        <source>Helix angle of the cutting edges</source>
        <translation>Angle d’hélice des arêtes</translation>
    </message>
    <message>
        <source>Radial depth</source>
        <translation>Prof. radiale</translation>
    </message>
    <message>
        <source>Radial depth of cut a_e, up to the diameter (slot); as given, it is not simulated along the path</source>
        <translation>Profondeur de passe radiale a_e, jusqu’au diamètre (rainure)&#xa0;; telle que donnée, elle n’est pas simulée le long de la trajectoire</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>Prof. axiale</translation>
    </message>
    <message>
        <source>Axial depth of cut a_p</source>
        <translation>Profondeur de passe axiale a_p</translation>
    </message>
    <message>
        <source>Spindle [1/min]</source>
        <translation>Broche [1/min]</translation>
    </message>
    <message>
        <source>Spindle speed where the program gives none; may be empty</source>
        <translation>Vitesse de broche là où le programme n’en donne pas&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>Least chip</source>
        <translation>Copeau min.</translation>
    </message>
    <message>
        <source>Chip thickness below which the edge rubs; places below it are listed; may be empty</source>
        <translation>Épaisseur de copeau sous laquelle l’arête frotte&#xa0;; les endroits en dessous sont listés&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>Max. chip</source>
        <translation>Copeau max.</translation>
    </message>
    <message>
        <source>Largest chip thickness allowed; places above it are listed; may be empty</source>
        <translation>Plus grande épaisseur de copeau admise&#xa0;; les endroits au-dessus sont listés&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>Max. force</source>
        <translation>Effort max.</translation>
    </message>
    <message>
        <source>Largest peak force allowed; places above it are listed; may be empty</source>
        <translation>Plus grand effort de crête admis&#xa0;; les endroits au-dessus sont listés&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>Max. torque</source>
        <translation>Couple max.</translation>
    </message>
    <message>
        <source>Largest torque allowed; places above it are listed; may be empty</source>
        <translation>Plus grand couple admis&#xa0;; les endroits au-dessus sont listés&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>Max. power</source>
        <translation>Puissance max.</translation>
    </message>
    <message>
        <source>Largest power allowed; places above it are listed; may be empty</source>
        <translation>Plus grande puissance admise&#xa0;; les endroits au-dessus sont listés&#xa0;; peut rester vide</translation>
    </message>
    <message>
        <source>all tools</source>
        <translation>tous les outils</translation>
    </message>
    <message>
        <source>up (conventional)</source>
        <translation>en opposition</translation>
    </message>
    <message>
        <source>down (climb)</source>
        <translation>en avalant</translation>
    </message>
    <message>
        <source>must be from %1 to %2</source>
        <translation>doit être de %1 à %2</translation>
    </message>
    <message>
        <source>must be above %1 and at most %2</source>
        <translation>doit être supérieur à %1 et au plus %2</translation>
    </message>
    <message>
        <source>must be ranges of lines, such as 10-25, 40-52; or empty</source>
        <translation>doit être des plages de lignes, comme 10-25, 40-52&#xa0;; ou vide</translation>
    </message>
    <message>
        <source>must be a whole number from 1 to %1</source>
        <translation>doit être un nombre entier de 1 à %1</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>n’est pas connu</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>As the program calls it</source>
        <translation>Tel que le programme l’appelle</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Where the operation applies, such as 10-25, 40-52; empty: wherever its tool cuts</source>
        <translation>Où l’opération s’applique, comme 10-25, 40-52&#xa0;; vide&#xa0;: partout où son outil coupe</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dents</translation>
    </message>
    <message>
        <source>Number of cutting edges, equally spaced</source>
        <translation>Nombre d’arêtes, également réparties</translation>
    </message>
    <message>
        <source>Milling</source>
        <translation>Fraisage</translation>
    </message>
    <message>
        <source>Up milling begins a chip thin, down milling thick: the side of the tool on which the material is</source>
        <translation>En opposition, le copeau commence mince&#xa0;; en avalant, épais&#xa0;: c’est le côté de l’outil où se trouve la matière</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Coefficients of the cutting force; each with its source</source>
        <translation>Coefficients de l’effort de coupe, chacun avec sa source</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PagePreview</name>
    <message>
        <source>Preview of the report</source>
        <translation>Aperçu du rapport</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PictureCommands</name>
    <message>
        <source>&amp;3D view</source>
        <translation>Vue &amp;3D</translation>
    </message>
    <message>
        <source>Copy the 3D view with its annotations to the clipboard</source>
        <translation>Copier la vue 3D et ses annotations dans le presse-papiers</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>&amp;Charts</source>
        <translation>&amp;Graphiques</translation>
    </message>
    <message>
        <source>Copy the charts to the clipboard</source>
        <translation>Copier les graphiques dans le presse-papiers</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenêtre</translation>
    </message>
    <message>
        <source>Copy all of the window to the clipboard</source>
        <translation>Copier toute la fenêtre dans le presse-papiers</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PictureDialog</name>
    <message>
        <source>&amp;Without a background</source>
        <translation>&amp;Sans fond</translation>
    </message>
    <message>
        <source>&amp;Save picture …</source>
        <translation>&amp;Enregistrer l’image …</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>The whole window</source>
        <translation>Toute la fenêtre</translation>
    </message>
    <message>
        <source>PNG: bitmap</source>
        <translation>PNG : image en points</translation>
    </message>
    <message>
        <source>SVG: drawing</source>
        <translation>SVG : dessin vectoriel</translation>
    </message>
    <message>
        <source>PDF: document</source>
        <translation>PDF : document</translation>
    </message>
    <message>
        <source>as in the window</source>
        <translation>comme dans la fenêtre</translation>
    </message>
    <message>
        <source>light</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>sombre</translation>
    </message>
    <message>
        <source>Pixels, such as 1920x1080, or a sheet of paper: A2 to A6, Letter, A4-portrait</source>
        <translation>Pixels, par exemple 1920x1080, ou une feuille de papier : A2 à A6, Letter, A4-portrait</translation>
    </message>
    <message>
        <source>Of paper, and of bitmaps in SVG and PDF; a PNG of so many pixels has none</source>
        <translation>Du papier, et des images en points dans SVG et PDF ; un PNG de tant de pixels n’en a pas</translation>
    </message>
    <message>
        <source>How much larger text and lines are; 1 suits 96 pixels an inch</source>
        <translation>Agrandissement du texte et des traits ; 1 convient à 96 pixels par pouce</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Contenu</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>&amp;Dots an inch</source>
        <translation>Points par &amp;pouce</translation>
    </message>
    <message>
        <source>&amp;Text and lines ×</source>
        <translation>Te&amp;xte et traits ×</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>Co&amp;uleurs</translation>
    </message>
    <message>
        <source>Drawing the preview …</source>
        <translation>Dessin de l’aperçu …</translation>
    </message>
    <message>
        <source>Preview of %1</source>
        <translation>Aperçu de %1</translation>
    </message>
    <message>
        <source>Preview of %1 × %2 pixels</source>
        <translation>Aperçu de %1 × %2 pixels</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Sheet: 3D view, charts and figures</source>
        <translation>Fiche&#xa0;: vue 3D, graphiques et chiffres</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PlaybackBar</name>
    <message>
        <source>Time within the cycle</source>
        <translation>Temps dans le cycle</translation>
    </message>
    <message>
        <source>Playback speed; 1 is real time</source>
        <translation>Vitesse de lecture&#xa0;; 1 = temps réel</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lecture ou pause</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Lecture ou pause</translation>
    </message>
    <message>
        <source>Ctrl+Left</source>
        <translation>Ctrl+Left</translation>
    </message>
    <message>
        <source>Ctrl+Right</source>
        <translation>Ctrl+Right</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Plus &amp;vite</translation>
    </message>
    <message>
        <source>Play twice as fast</source>
        <translation>Lire deux fois plus vite</translation>
    </message>
    <message>
        <source>Ctrl+Up</source>
        <translation>Ctrl+Up</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>&amp;Moins vite</translation>
    </message>
    <message>
        <source>Play half as fast</source>
        <translation>Lire deux fois moins vite</translation>
    </message>
    <message>
        <source>Ctrl+Down</source>
        <translation>Ctrl+Down</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>En &amp;boucle</translation>
    </message>
    <message>
        <source>Repeat the time range of the charts</source>
        <translation>Lire en boucle ce que montrent les graphiques</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pre&amp;vious block</source>
        <translation>Bloc &amp;précédent</translation>
    </message>
    <message>
        <source>Go to the start of this or the previous block</source>
        <translation>Aller au début de ce bloc ou du précédent</translation>
    </message>
    <message>
        <source>Ne&amp;xt block</source>
        <translation>Bloc &amp;suivant</translation>
    </message>
    <message>
        <source>Go to the start of the next block</source>
        <translation>Aller au début du bloc suivant</translation>
    </message>
    <message>
        <source>P&amp;revious sample</source>
        <translation>Échantillon p&amp;récédent</translation>
    </message>
    <message>
        <source>Go back one interpolation period</source>
        <translation>Reculer d’une période d’interpolation</translation>
    </message>
    <message>
        <source>&amp;Next sample</source>
        <translation>Échantillon s&amp;uivant</translation>
    </message>
    <message>
        <source>Go forward one interpolation period</source>
        <translation>Avancer d’une période d’interpolation</translation>
    </message>
    <message>
        <source>Go to s&amp;tart</source>
        <translation>Aller au &amp;début</translation>
    </message>
    <message>
        <source>Go to the start of the run</source>
        <translation>Aller au début de la simulation</translation>
    </message>
    <message>
        <source>Go to &amp;end</source>
        <translation>Aller à la &amp;fin</translation>
    </message>
    <message>
        <source>Go to the end of the run</source>
        <translation>Aller à la fin de la simulation</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PolarPlot</name>
    <message>
        <source>%1: G %2 (least squares %3), F_max %4, F_min %5</source>
        <translation>%1 : G %2 (moindres carrés %3), F_max %4, F_min %5</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>sens trigonométrique</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>sens horaire</translation>
    </message>
    <message>
        <source>both directions: G(b) %1, D %2</source>
        <translation>les deux sens : G(b) %1, D %2</translation>
    </message>
    <message>
        <source>%1 a division</source>
        <translation>%1 par division</translation>
    </message>
    <message>
        <source>R %1, %2, %3</source>
        <translation>R %1, %2, %3</translation>
    </message>
    <message>
        <source>mean radial deviation %1</source>
        <translation>écart radial moyen %1</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1 : %2</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::Presentation</name>
    <message>
        <source>&amp;Presentation</source>
        <translation>Prése&amp;ntation</translation>
    </message>
    <message>
        <source>class projector beamer large type bigger letters teach</source>
        <translation>classe cours projecteur vidéoprojecteur grand caractères lettres agrandir enseigner</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Use the whole screen, without a frame</source>
        <translation>Utiliser tout l’écran, sans cadre</translation>
    </message>
    <message>
        <source>Large type and the open lesson alone, with its 3D view and charts: for a class</source>
        <translation>Grands caractères et la leçon ouverte seule, avec sa vue 3D et ses courbes : pour une classe</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>While presenting: next question or answer of the lesson</source>
        <translation>Pendant la présentation : question ou réponse suivante de la leçon</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>While presenting: previous question or answer of the lesson</source>
        <translation>Pendant la présentation : question ou réponse précédente de la leçon</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::PrintDialog</name>
    <message>
        <source>&amp;Print …</source>
        <translation>&amp;Imprimer …</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Fiche</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Hand-out for learners</source>
        <translation>Polycopié pour les apprenants</translation>
    </message>
    <message>
        <source>Hand-out for the teacher</source>
        <translation>Polycopié pour l’enseignant</translation>
    </message>
    <message>
        <source>Hand-out for everybody</source>
        <translation>Polycopié pour tous</translation>
    </message>
    <message>
        <source>Table: %1</source>
        <translation>Tableau : %1</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Quoi</translation>
    </message>
    <message>
        <source>What is printed: as the window shows it now</source>
        <translation>Ce qui est imprimé : tel que la fenêtre le montre</translation>
    </message>
    <message>
        <source>Preview of the pages</source>
        <translation>Aperçu des pages</translation>
    </message>
    <message>
        <source>Choose a printer, or a PDF file, and print these pages</source>
        <translation>Choisir une imprimante ou un fichier PDF, et imprimer ces pages</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>There is nothing to print: open a program or a lesson first.</source>
        <translation>Il n’y a rien à imprimer : ouvrez d’abord un programme ou une leçon.</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 sur %2</translation>
    </message>
    <message>
        <source>Making the pages …</source>
        <translation>Préparation des pages …</translation>
    </message>
    <message>
        <source>1 page</source>
        <translation>1 page</translation>
    </message>
    <message>
        <source>%1 pages</source>
        <translation>%1 pages</translation>
    </message>
    <message>
        <source>The printer reports an error; nothing was printed.</source>
        <translation>L’imprimante signale une erreur ; rien n’a été imprimé.</translation>
    </message>
    <message>
        <source>%1 has been sent to %2</source>
        <translation>%1 : envoyé à %2</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Show the page as a whole</source>
        <translation>Afficher la page entière</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Show the page as wide as there is room</source>
        <translation>Afficher la page sur toute la largeur</translation>
    </message>
    <message>
        <source>Show the page larger</source>
        <translation>Afficher la page plus grande</translation>
    </message>
    <message>
        <source>Show the page smaller</source>
        <translation>Afficher la page plus petite</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ProgramMargin</name>
    <message>
        <source>Not in the cycle time: tool change; give the tool change time of the machine</source>
        <translation>Non compté&#xa0;: changement d’outil&#xa0;; le temps de changement d’outil de la machine le donne</translation>
    </message>
    <message>
        <source>Not in the cycle time: spindle start; give the spindle start time of the machine</source>
        <translation>Non compté&#xa0;: démarrage de la broche&#xa0;; le temps de démarrage de la broche de la machine le donne</translation>
    </message>
    <message>
        <source>Not in the cycle time: program stop</source>
        <translation>Non compté&#xa0;: arrêt programmé</translation>
    </message>
    <message>
        <source>Neither drawn nor in the cycle time: move to or from a machine position; give the positions of the machine</source>
        <translation>Ni tracé ni compté&#xa0;: déplacement vers ou depuis une position machine&#xa0;; les positions de la machine le donnent</translation>
    </message>
    <message>
        <source>Line %1 takes no time</source>
        <translation>La ligne %1 ne prend pas de temps</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ProgramPanel</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Find …</source>
        <translation>Rechercher …</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Rechercher le suivant</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Rechercher le précédent</translation>
    </message>
    <message>
        <source>Go to line …</source>
        <translation>Aller à la ligne …</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Texte plus grand</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Texte plus petit</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Copy program text</source>
        <translation>Copier le texte du programme</translation>
    </message>
    <message>
        <source>Copy the selected text (Ctrl+C)</source>
        <translation>Copier le texte sélectionné (Ctrl+C)</translation>
    </message>
    <message>
        <source>Select all program text</source>
        <translation>Sélectionner tout le programme</translation>
    </message>
    <message>
        <source>Select the whole program (Ctrl+A)</source>
        <translation>Sélectionner tout le programme (Ctrl+A)</translation>
    </message>
    <message>
        <source>Find in the program</source>
        <translation>Rechercher dans le programme</translation>
    </message>
    <message>
        <source>Go to a line of the program</source>
        <translation>Aller à une ligne du programme</translation>
    </message>
    <message>
        <source>Larger program text; Ctrl and the wheel do the same</source>
        <translation>Agrandir le texte du programme&#xa0;; Ctrl et la molette font de même</translation>
    </message>
    <message>
        <source>Smaller program text; Ctrl and the wheel do the same</source>
        <translation>Réduire le texte du programme&#xa0;; Ctrl et la molette font de même</translation>
    </message>
    <message>
        <source>Cutting [%1]: %2</source>
        <translation>Usinage [%1] : %2</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>Aller à l’occurrence suivante</translation>
    </message>
    <message>
        <source>Go to the previous match</source>
        <translation>Aller à l’occurrence précédente</translation>
    </message>
    <message>
        <source>Extents [%1], including arcs
Cutting: %2
Rapid: %3
All: %4</source>
        <translation>Étendue [%1], arcs compris
Usinage&#xa0;: %2
Rapide&#xa0;: %3
Ensemble&#xa0;: %4</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ProgramView</name>
    <message>
        <source>Program text</source>
        <translation>Texte du programme</translation>
    </message>
    <message>
        <source>Text of the NC program with the time of every line</source>
        <translation>Texte du programme CN avec le temps de chaque ligne</translation>
    </message>
    <message>
        <source>Open an NC program (Ctrl+O), or drop one here.</source>
        <translation>Ouvrir un programme CN (Ctrl+O), ou en déposer un ici.</translation>
    </message>
    <message>
        <source>The program is empty.</source>
        <translation>Le programme est vide.</translation>
    </message>
    <message>
        <source>Reading the program …</source>
        <translation>Lecture du programme …</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ReadingDialog</name>
    <message>
        <source>Simulate a program that was cut off at this limit</source>
        <translation>Simuler un programme interrompu à cette limite</translation>
    </message>
    <message>
        <source>For programs whose CAM system has already compensated the tool radius; a radius that is set here still applies</source>
        <translation>Pour les programmes dont la FAO a déjà intégré le rayon de l’outil à la trajectoire ; un rayon saisi ici reste appliqué</translation>
    </message>
    <message>
        <source>Work offsets</source>
        <translation>Décalages d’origine</translation>
    </message>
    <message>
        <source>set here</source>
        <translation>saisi ici</translation>
    </message>
    <message>
        <source>Skip blocks that begin with /</source>
        <translation>Omettre les blocs qui commencent par /</translation>
    </message>
    <message>
        <source>Program import options</source>
        <translation>Options d’importation du programme</translation>
    </message>
    <message>
        <source>Cutter radii</source>
        <translation>Rayons des fraises</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>set here, not used by the program</source>
        <translation>saisi ici, non utilisé par le programme</translation>
    </message>
    <message>
        <source>Empty: the radius of the program or the tool table</source>
        <translation>Vide : selon le programme ou la table d’outils</translation>
    </message>
    <message>
        <source>a table in the folder of the program, if there is one</source>
        <translation>celle à côté du programme, s’il y en a une</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>Unit of a tool table that does not state it</source>
        <translation>Unité d’une table d’outils qui ne la nomme pas</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Choisir …</translation>
    </message>
    <message>
        <source>Maximum lines executed by loops and calls</source>
        <translation>Nombre maximal de lignes exécutées par les boucles et les appels</translation>
    </message>
    <message>
        <source>Maximum call depth</source>
        <translation>Profondeur maximale des appels</translation>
    </message>
    <message>
        <source>Tool table</source>
        <translation>Table d’outils</translation>
    </message>
    <message>
        <source>The program uses no cutter radius compensation.</source>
        <translation>Le programme n’active aucune correction de rayon.</translation>
    </message>
    <message>
        <source>Choose a tool table</source>
        <translation>Choisir une table d’outils</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Unit of the program</source>
        <translation>Unité du programme</translation>
    </message>
    <message>
        <source>as programmed (now %1)</source>
        <translation>celle du programme (actuellement %1)</translation>
    </message>
    <message>
        <source>as programmed, otherwise mm</source>
        <translation>celle du programme, sinon mm</translation>
    </message>
    <message>
        <source>Unit of lengths and feeds until the program sets one: G20, G21, G70, G71, BEGIN PGM ... MM</source>
        <translation>Unité des longueurs et des avances tant que le programme n’en indique pas : G20, G21, G70, G71, BEGIN PGM ... MM</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The radius of tool %1, &quot;%2&quot;, is not a length of 0 or more.</source>
        <translation>Le rayon de l’outil %1, « %2 », n’est pas une longueur de 0 ou plus.</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>tool table</source>
        <translation>table d’outils</translation>
    </message>
    <message>
        <source>unknown: the programmed contour is shown</source>
        <translation>inconnu&#xa0;: le contour programmé est affiché</translation>
    </message>
    <message>
        <source>Path already compensated (wear only): radius 0</source>
        <translation>La trajectoire est déjà compensée (usure seule)&#xa0;: rayon 0</translation>
    </message>
    <message>
        <source>auto-detected</source>
        <translation>détecté automatiquement</translation>
    </message>
    <message>
        <source>auto-detected (now %1)</source>
        <translation>détecté automatiquement (ici %1)</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Endless loops are cut off at this limit</source>
        <translation>Les boucles sans fin sont coupées à cette limite</translation>
    </message>
    <message>
        <source>LinuxCNC, Sinumerik, Fanuc (G10) or Heidenhain (TOOL.T) format, or a list with the headings T and R</source>
        <translation>Format LinuxCNC, Sinumerik, Fanuc (G10) ou Heidenhain (TOOL.T), ou une liste avec les en-têtes T et R</translation>
    </message>
    <message>
        <source>Dialect of the program</source>
        <translation>Dialecte du programme</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecte</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RecordingsBox</name>
    <message>
        <source>Recordings that are used</source>
        <translation>Enregistrements utilisés</translation>
    </message>
    <message>
        <source>%1: trace, %2</source>
        <translation>%1&#xa0;: trace, %2</translation>
    </message>
    <message>
        <source>%1: %2 section times</source>
        <translation>%1&#xa0;: %2 temps de sections</translation>
    </message>
    <message>
        <source>Open the program that ran on your machine. For most numbers run the test program: write it here, and open it.</source>
        <translation>Ouvrir le programme qui a tourné sur votre machine. Le programme d’essai révèle le plus de nombres&#xa0;: l’écrire ici, et l’ouvrir.</translation>
    </message>
    <message>
        <source>Record X, Y and Z on the control while this program runs, best at 1 to 4 ms a sample, and open the trace. Without a trace: write the times of its sections into a table with the titles section,seconds and open that. The test program tells most numbers.</source>
        <translation>Enregistrer X, Y et Z sur la commande pendant que ce programme tourne, au mieux un échantillon toutes les 1 à 4&#xa0;ms, et ouvrir la trace. Sans trace&#xa0;: écrire les temps de ses sections dans un tableau aux titres section,seconds et l’ouvrir. Le programme d’essai révèle le plus de nombres.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RemedyTable</name>
    <message>
        <source>%1: being simulated</source>
        <translation>%1&#xa0;: simulation en cours</translation>
    </message>
    <message>
        <source>%1: the program takes %2 instead of %3, the place at the cursor %4 instead of %5</source>
        <translation>%1&#xa0;: le programme prend %2 au lieu de %3, l’endroit autour du curseur %4 au lieu de %5</translation>
    </message>
    <message>
        <source>Cycle time with the change</source>
        <translation>Temps de cycle avec le changement</translation>
    </message>
    <message>
        <source>Change in cycle time: shorter (−) or longer (+)</source>
        <translation>Temps de cycle plus court (−) ou plus long (+) d’autant</translation>
    </message>
    <message>
        <source>The same for the blocks around the cursor</source>
        <translation>De même pour les blocs autour du curseur</translation>
    </message>
    <message>
        <source>The change; double-click to make it a new run</source>
        <translation>Ce qui est changé&#xa0;; un double-clic en fait une simulation</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ReportDialog</name>
    <message>
        <source>With the date of today</source>
        <translation>Avec la date du jour</translation>
    </message>
    <message>
        <source>Save the session beside it, to make it again</source>
        <translation>Enregistrer la session à côté, pour le refaire</translation>
    </message>
    <message>
        <source>&amp;Save report …</source>
        <translation>&amp;Enregistrer …</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>as supplied</source>
        <translation>fourni avec Feedscope</translation>
    </message>
    <message>
        <source>What is to be said first, in your words</source>
        <translation>Ce qui est à dire d’abord, en vos mots</translation>
    </message>
    <message>
        <source>Own words</source>
        <translation>Texte libre</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titre</translation>
    </message>
    <message>
        <source>&amp;Author</source>
        <translation>&amp;Auteur</translation>
    </message>
    <message>
        <source>&amp;Own words</source>
        <translation>Texte &amp;libre</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>Lo&amp;go</translation>
    </message>
    <message>
        <source>Picture above the title: PNG, JPEG or SVG</source>
        <translation>Image au-dessus du titre : PNG, JPEG ou SVG</translation>
    </message>
    <message>
        <source>T&amp;emplate</source>
        <translation>&amp;Modèle</translation>
    </message>
    <message>
        <source>HTML template of your own</source>
        <translation>Modèle HTML personnel</translation>
    </message>
    <message>
        <source>&amp;Runs</source>
        <translation>&amp;Simulations</translation>
    </message>
    <message>
        <source>What &amp;goes in</source>
        <translation>&amp;Contenu</translation>
    </message>
    <message>
        <source>Writes a session file of the same name, and the command that makes the report of it</source>
        <translation>Écrit un fichier de session du même nom, et la commande qui en fait le rapport</translation>
    </message>
    <message>
        <source>Tick a run at least.</source>
        <translation>Cocher au moins une simulation.</translation>
    </message>
    <message>
        <source>Making the preview …</source>
        <translation>Aperçu en préparation …</translation>
    </message>
    <message>
        <source>1 page</source>
        <translation>1 page</translation>
    </message>
    <message>
        <source>%1 pages</source>
        <translation>%1 pages</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg);;All files (*)</source>
        <translation>Images (*.png *.jpg *.jpeg *.svg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>HTML (*.html *.htm);;All files (*)</source>
        <translation>HTML (*.html *.htm);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Document (*.pdf);;Web page (*.html)</source>
        <translation>Document (*.pdf);;Page web (*.html)</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>La&amp;ngue</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ResidualChart</name>
    <message>
        <source>What the models leave over of the recordings</source>
        <translation>Ce que les modèles laissent de côté des enregistrements</translation>
    </message>
    <message>
        <source>How far the simulation is behind the recording as it goes on, or what it is longer in each section. A level curve: feed and time agree there; a step: a place that takes longer or shorter</source>
        <translation>De combien la simulation prend du retard sur l’enregistrement à mesure qu’il avance, ou de combien elle est plus longue dans chaque section. Une courbe horizontale&#xa0;: avance et temps y concordent&#xa0;; une marche&#xa0;: un endroit qui prend plus ou moins de temps</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ResultBox</name>
    <message>
        <source>Models by how well they explain the recording</source>
        <translation>Modèles selon ce qu’ils expliquent de l’enregistrement</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Explique</translation>
    </message>
    <message>
        <source>Control model; the one that explains best first</source>
        <translation>Modèle de commande&#xa0;; celui qui explique le mieux en premier</translation>
    </message>
    <message>
        <source>Root mean square of what the model leaves over; 1 is noise and sampling alone</source>
        <translation>Moyenne quadratique de ce que le modèle laisse de côté&#xa0;; 1&#xa0;: bruit et échantillonnage seuls</translation>
    </message>
    <message>
        <source>Difference of the feeds (rms), as a share of the mean feed</source>
        <translation>Écart des avances (moyenne quadratique), en part de l’avance moyenne</translation>
    </message>
    <message>
        <source>Within 5 % of the feed and 1 % of the time</source>
        <translation>À moins de 5&#xa0;% de l’avance et 1&#xa0;% du temps</translation>
    </message>
    <message>
        <source>Numbers that were looked for</source>
        <translation>Nombres cherchés</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>Limit of an axis or setting of the control</source>
        <translation>Limite d’un axe ou réglage de la commande</translation>
    </message>
    <message>
        <source>Value that was begun with</source>
        <translation>Valeur de départ</translation>
    </message>
    <message>
        <source>Value that explains the recording best, ± 95 %</source>
        <translation>Valeur qui explique le mieux l’enregistrement, ± à 95&#xa0;%</translation>
    </message>
    <message>
        <source>Recordings, models or machine have changed since: identify again.</source>
        <translation>Enregistrements, modèles ou machine ont changé depuis&#xa0;: identifier de nouveau.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Tick other models in step 2.</source>
        <translation>Cocher d’autres modèles à l’étape 2.</translation>
    </message>
    <message>
        <source>roughly</source>
        <translation>à peu près</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RunList</name>
    <message>
        <source>duplicate run</source>
        <translation>copie de simulation</translation>
    </message>
    <message>
        <source>remove run</source>
        <translation>suppression de simulation</translation>
    </message>
    <message>
        <source>move run</source>
        <translation>déplacement de simulation</translation>
    </message>
    <message>
        <source>name of run</source>
        <translation>nom de simulation</translation>
    </message>
    <message>
        <source>colour of run</source>
        <translation>couleur de simulation</translation>
    </message>
    <message>
        <source>show run</source>
        <translation>affichage de simulation</translation>
    </message>
    <message>
        <source>hide run</source>
        <translation>masquage de simulation</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>changed settings, behind two of them</comment>
        <translation>
            <numerusform>%n autre</numerusform>
            <numerusform>%n autres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RunNotice</name>
    <message>
        <source>Simulate again</source>
        <translation>Simuler de nouveau</translation>
    </message>
    <message>
        <source>Simulate the current run (F9)</source>
        <translation>Simuler la simulation courante (F9)</translation>
    </message>
    <message>
        <source>The run “%1” was cancelled: it has no result.</source>
        <translation>La simulation « %1 » a été annulée : il n’y a rien à en montrer.</translation>
    </message>
    <message>
        <source>The run “%1” has failed: %2</source>
        <translation>La simulation « %1 » a échoué : %2</translation>
    </message>
    <message>
        <source>No program is shown. %1</source>
        <translation>Aucun programme n’est affiché. %1</translation>
    </message>
    <message>
        <source>Nothing in %1 moves an axis. Check that it is an NC program; it was read as %2, and File › Reading › Program import options selects another language. The panel Messages lists what was found in it.</source>
        <translation>Rien dans %1 ne déplace un axe. Vérifiez qu’il s’agit d’un programme CN ; il a été lu comme %2, et Fichier › Lecture › Options d’importation permet de choisir un autre langage. Le panneau Messages dit ce qu’on y a trouvé.</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Read the program again and simulate it (F9)</source>
        <translation>Relire le programme et le simuler (F9)</translation>
    </message>
    <message>
        <source>Reading the program …</source>
        <translation>Lecture du programme …</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RunTable</name>
    <message>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>Slower [%]</source>
        <translation>Plus lent [%]</translation>
    </message>
    <message>
        <source>Name of the run; the box shows its path and feed together with those of the current run</source>
        <translation>Nom de la simulation&#xa0;; la case affiche sa trajectoire et son avance à côté de celles de la simulation actuelle</translation>
    </message>
    <message>
        <source>Machine whose axis limits apply</source>
        <translation>Machine dont les limites d’axe s’appliquent</translation>
    </message>
    <message>
        <source>Control model</source>
        <translation>Modèle de commande</translation>
    </message>
    <message>
        <source>Cycle time [s, or min:s]; the star marks the fastest run within the error bound</source>
        <translation>Temps de cycle [s, ou min:s]&#xa0;; l’étoile marque la simulation la plus rapide qui respecte la borne d’erreur</translation>
    </message>
    <message>
        <source>Cycle time above that of the fastest run [%]</source>
        <translation>Temps de cycle au-dessus de celui de la simulation la plus rapide [%]</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>It was cancelled and has no result. Simulate it again with F9.</source>
        <translation>Elle a été annulée et n’a pas de résultat. Simulez-la de nouveau avec F9.</translation>
    </message>
    <message>
        <source>It failed: %1</source>
        <translation>Elle a échoué : %1</translation>
    </message>
    <message>
        <source>Its contour error of %1 is above the bound of %2.</source>
        <translation>Son erreur de contour de %1 dépasse la borne de %2.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Mean feed</source>
        <translation>Avance moyenne</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Contour tolerance in force, from the program or the setting</source>
        <translation>Tolérance de contour en vigueur, du programme ou du réglage</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>What a control recorded. The panel Trace says how well the current run agrees.</source>
        <translation>Ce qu’une commande a enregistré. Le panneau Trace dit à quel point la simulation actuelle concorde.</translation>
    </message>
    <message>
        <source>It covers %1 % of the path: a cycle time is not known.</source>
        <translation>Elle couvre %1 % de la trajectoire&#xa0;: le temps de cycle n’est pas connu.</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusée</translation>
    </message>
    <message>
        <source>The control refuses the program: none of its feed motions is run, and there is no cycle time.</source>
        <translation>La commande refuse le programme&#xa0;: aucun de ses déplacements en avance n’est exécuté, il n’y a pas de temps de cycle.</translation>
    </message>
    <message>
        <source>Lines that the control refuses and that are not run: %1.</source>
        <translation>Lignes que la commande refuse et qui ne sont pas exécutées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1, out of reach</source>
        <translation>%1, hors de portée</translation>
    </message>
    <message>
        <source>The program sends rotary axes where the machine cannot turn them: the time is not that of the program.</source>
        <translation>Le programme envoie des axes rotatifs là où la machine ne peut pas les tourner : le temps n’est pas celui du programme.</translation>
    </message>
    <message>
        <source>In rapids it leaves the programmed path by up to %1.</source>
        <translation>Dans les rapides, elle s’écarte de la trajectoire programmée jusqu’à %1.</translation>
    </message>
    <message>
        <source>Largest distance of the executed path from the programmed one in feed motions</source>
        <translation>Plus grande distance de la trajectoire exécutée à la trajectoire programmée, en avance</translation>
    </message>
    <message>
        <source>★ The run to take: %1</source>
        <translation>★ La simulation à retenir&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mean feed with rapids: executed path over cycle time without dwells</source>
        <translation>Avance moyenne, rapides compris&#xa0;: trajectoire exécutée divisée par le temps de cycle sans les pauses</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::RunsView</name>
    <message>
        <source>Runs and their results</source>
        <translation>Simulations et leurs résultats</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Ctrl+Delete</source>
        <translation>Ctrl+Delete</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move the current run up</source>
        <translation>Monter la simulation actuelle dans la liste</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <translation>D&amp;escendre</translation>
    </message>
    <message>
        <source>Move the current run down</source>
        <translation>Descendre la simulation actuelle dans la liste</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
    <message>
        <source>&amp;Colour …</source>
        <translation>&amp;Couleur …</translation>
    </message>
    <message>
        <source>Colour of the run</source>
        <translation>Couleur de la simulation</translation>
    </message>
    <message>
        <source>&amp;Simulate again</source>
        <translation>&amp;Simuler de nouveau</translation>
    </message>
    <message>
        <source>Simulate the current run, which was cancelled or failed</source>
        <translation>Simuler la simulation courante, annulée ou en échec</translation>
    </message>
    <message>
        <source>R&amp;ename</source>
        <translation>R&amp;enommer</translation>
    </message>
    <message>
        <source>Type a name for the current run; empty: named by its machine and settings</source>
        <translation>Saisir un nom pour la simulation courante ; sans nom, elle porte celui de ses réglages</translation>
    </message>
    <message>
        <source>Copy the current run to change it</source>
        <translation>Copier la simulation courante pour la modifier</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Simulations</translation>
    </message>
    <message>
        <source>Save the runs as CSV …</source>
        <translation>Enregistrer les simulations en CSV …</translation>
    </message>
    <message>
        <source>The numbers of the runs that are simulated, one row per run, with their names</source>
        <translation>Les valeurs des simulations faites, une ligne par simulation, avec leurs noms</translation>
    </message>
    <message>
        <source>export table spreadsheet</source>
        <translation>exporter tableau tableur</translation>
    </message>
    <message>
        <source>There is no run to save: open a program first.</source>
        <translation>Il n’y a pas de simulation à enregistrer : ouvrir d’abord un programme.</translation>
    </message>
    <message>
        <source>Save the runs</source>
        <translation>Enregistrer les simulations</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 ne peut pas être écrit : %2.</translation>
    </message>
    <message>
        <source>Remove the current run, or the trace that is selected</source>
        <translation>Supprimer la simulation actuelle, ou la trace sélectionnée</translation>
    </message>
    <message>
        <source>Colour of the current run in charts and 3D view, or of the selected trace in charts</source>
        <translation>Couleur de la simulation actuelle dans les graphiques et la vue 3D, ou de la trace sélectionnée dans les graphiques</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SceneActions</name>
    <message>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Couleur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Exaggeration of deviations from the programmed path</source>
        <translation>Amplification des écarts à la trajectoire programmée</translation>
    </message>
    <message>
        <source>Exaggerate deviations from the programmed path by this factor</source>
        <translation>Dessiner les écarts à la trajectoire programmée agrandis d’autant</translation>
    </message>
    <message>
        <source>Deviation %1</source>
        <translation>Écart %1</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Standard views, projection, axes</source>
        <translation>Vues standard, projection, axes</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrique</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Dessus</translation>
    </message>
    <message>
        <source>View from above, X to the right</source>
        <translation>Vue de dessus, X vers la droite</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Face</translation>
    </message>
    <message>
        <source>View from the front, X to the right</source>
        <translation>Vue de face, X vers la droite</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Dr&amp;oite</translation>
    </message>
    <message>
        <source>View from the right, Y to the right</source>
        <translation>Vue de droite, Y vers la droite</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>De&amp;ssous</translation>
    </message>
    <message>
        <source>View from below, X to the right</source>
        <translation>Vue de dessous, X vers la droite</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>A&amp;rrière</translation>
    </message>
    <message>
        <source>View from behind, X to the left</source>
        <translation>Vue de l’arrière, X vers la gauche</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>View from the left, Y to the left</source>
        <translation>Vue de gauche, Y vers la gauche</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspective</translation>
    </message>
    <message>
        <source>Perspective: nearer parts look larger; without it lengths can be compared</source>
        <translation>Ce qui est proche paraît plus grand&#xa0;; sans elle, les longueurs se comparent</translation>
    </message>
    <message>
        <source>&amp;Grid and axes</source>
        <translation>Gri&amp;lle et axes</translation>
    </message>
    <message>
        <source>Rapids that co&amp;ver the picture</source>
        <translation>Rapides qui cou&amp;vrent l’image</translation>
    </message>
    <message>
        <source>Show rapids even where they cover more than 5 % of the picture</source>
        <translation>Montrer les rapides même là où ils couvrent plus de 5&#xa0;% de l’image</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Flat end mill</source>
        <translation>Fraise cylindrique</translation>
    </message>
    <message>
        <source>A cylinder</source>
        <translation>Un cylindre</translation>
    </message>
    <message>
        <source>Ball end mill</source>
        <translation>Fraise hémisphérique</translation>
    </message>
    <message>
        <source>Bull nose end mill</source>
        <translation>Fraise torique</translation>
    </message>
    <message>
        <source>A cylinder with rounded corners</source>
        <translation>Un cylindre à coins arrondis</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Aucun outil</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Rayon de coin</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>&amp;Zone</translation>
    </message>
    <message>
        <source>To &amp;charts</source>
        <translation>&amp;Vers graphiques</translation>
    </message>
    <message>
        <source>Zoom the charts to the time range of the 3D view</source>
        <translation>Les graphiques montrent la plage de temps de ce qui est visible</translation>
    </message>
    <message>
        <source>Fit &amp;path</source>
        <translation>Cadrer la &amp;trajectoire</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>There is no other run to compare with: duplicate the run (Ctrl+D) and change the copy</source>
        <translation>Il n’y a pas d’autre simulation à comparer&#xa0;: dupliquez la simulation (Ctrl+D) et modifiez la copie</translation>
    </message>
    <message>
        <source>A box with grids around the path that shows its size</source>
        <translation>Un cadre quadrillé autour de la trajectoire, qui en montre la taille</translation>
    </message>
    <message>
        <source>Diameter of the cutter</source>
        <translation>Diamètre de la fraise</translation>
    </message>
    <message>
        <source>Corner radius of a bull nose end mill</source>
        <translation>Rayon de coin d’une fraise torique</translation>
    </message>
    <message>
        <source>Quantity shown by the colour of the executed path</source>
        <translation>Grandeur représentée par la couleur de la trajectoire exécutée</translation>
    </message>
    <message>
        <source>Colour the path by this quantity</source>
        <translation>Colorer la trajectoire selon cette grandeur</translation>
    </message>
    <message>
        <source>Colour the path by the difference from another run</source>
        <translation>Colorer la trajectoire selon la différence avec une autre simulation</translation>
    </message>
    <message>
        <source>View from the right, front and top</source>
        <translation>Vue de droite, de face et de dessus</translation>
    </message>
    <message>
        <source>Tool drawn at the cursor</source>
        <translation>L’outil dessiné au curseur</translation>
    </message>
    <message>
        <source>A cone that marks the place, without dimensions</source>
        <translation>Un cône qui marque l’endroit, sans dimension</translation>
    </message>
    <message>
        <source>A cylinder with a hemispherical end</source>
        <translation>Un cylindre à bout hémisphérique</translation>
    </message>
    <message>
        <source>Show nothing at the cursor</source>
        <translation>Ne rien afficher au curseur</translation>
    </message>
    <message>
        <source>Click two points on the path to measure the distance, path length and time between them</source>
        <translation>Cliquer deux points de la trajectoire pour mesurer la distance, la longueur de trajectoire et le temps entre eux</translation>
    </message>
    <message>
        <source>Drag a box to zoom the view and the charts to it</source>
        <translation>Tracer une zone pour y zoomer la vue et les graphiques</translation>
    </message>
    <message>
        <source>Fit the whole path into the view</source>
        <translation>Cadrer toute la trajectoire dans la vue</translation>
    </message>
    <message>
        <source>&amp;Actual path</source>
        <translation>Trajectoire &amp;réelle</translation>
    </message>
    <message>
        <source>The path that the axes run, drawn beside the one that the control sets</source>
        <translation>La trajectoire que les axes parcourent, dessinée à côté de celle que la commande demande</translation>
    </message>
    <message>
        <source>The machine has no drives: give its axes kv_1_s</source>
        <translation>La machine n’a pas d’entraînements : donner kv_1_s à ses axes</translation>
    </message>
    <message>
        <source>Say how the tools are engaged in the panel Cutting load</source>
        <translation>Indiquer l’engagement des outils dans le panneau Charge de coupe</translation>
    </message>
    <message>
        <source>Rapi&amp;ds</source>
        <translation>Ra&amp;pides</translation>
    </message>
    <message>
        <source>hide show G0</source>
        <translation>cacher masquer montrer G0</translation>
    </message>
    <message>
        <source>Show rapids here and in the charts; without them the path that cuts lies open</source>
        <translation>Afficher les rapides ici et dans les graphiques ; sans eux, la trajectoire qui usine est dégagée</translation>
    </message>
    <message>
        <source>&amp;Whole path</source>
        <translation>T&amp;oute la trajectoire</translation>
    </message>
    <message>
        <source>Draw all of the path in full</source>
        <translation>Dessiner toute la trajectoire pleinement</translation>
    </message>
    <message>
        <source>&amp;Only the chart range</source>
        <translation>Seule la plage des &amp;graphiques</translation>
    </message>
    <message>
        <source>Draw what the charts show in full, the rest of the path pale or not at all</source>
        <translation>Dessiner pleinement ce que montrent les graphiques, le reste de la trajectoire pâle ou pas du tout</translation>
    </message>
    <message>
        <source>layer level clip transparent isolate</source>
        <translation>couche niveau couper transparent isoler</translation>
    </message>
    <message>
        <source>&amp;Up to the cursor</source>
        <translation>&amp;Jusqu’au curseur</translation>
    </message>
    <message>
        <source>Draw what has been run up to the cursor in full, the rest of the path pale or not at all</source>
        <translation>Dessiner pleinement ce qui a été parcouru jusqu’au curseur, le reste de la trajectoire pâle ou pas du tout</translation>
    </message>
    <message>
        <source>trail trace playback</source>
        <translation>traînée trace lecture</translation>
    </message>
    <message>
        <source>&amp;Hide the rest</source>
        <translation>&amp;Masquer le reste</translation>
    </message>
    <message>
        <source>Hide the rest of the path, with all that lies outside of the box around what is drawn in full</source>
        <translation>Masquer le reste de la trajectoire, avec tout ce qui est hors de la boîte autour de ce qui est dessiné pleinement</translation>
    </message>
    <message>
        <source>Machine a&amp;xes</source>
        <translation>A&amp;xes de la machine</translation>
    </message>
    <message>
        <source>Draw the run where X, Y and Z of the machine stand while rotary axes turn, instead of the tip on the part</source>
        <translation>Dessiner la simulation là où X, Y et Z de la machine se trouvent pendant que des axes rotatifs tournent, au lieu de la pointe sur la pièce</translation>
    </message>
    <message>
        <source>rotary five axis kinematics coordinates</source>
        <translation>rotatif cinq axes cinématique coordonnées</translation>
    </message>
    <message>
        <source>Acceleration and jerk</source>
        <translation>Accélération et jerk</translation>
    </message>
    <message>
        <source>Cutting load</source>
        <translation>Charge de coupe</translation>
    </message>
    <message>
        <source>Difference between runs</source>
        <translation>Différence entre simulations</translation>
    </message>
    <message>
        <source>&amp;Shown</source>
        <translation>&amp;Affiché</translation>
    </message>
    <message>
        <source>&amp;Drawn in full</source>
        <translation>&amp;Dessiné en entier</translation>
    </message>
    <message>
        <source>&amp;Zoom and measure</source>
        <translation>&amp;Zoom et mesure</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SceneRun</name>
    <message>
        <source>the other half</source>
        <translation>l’autre moitié</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SceneView</name>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SettingsTable</name>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SetupBar</name>
    <message>
        <source>Setup</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>Machine whose axis limits and control settings apply</source>
        <translation>Machine dont les limites d’axe et les réglages de commande s’appliquent</translation>
    </message>
    <message>
        <source>Control model: how the control turns the path into motion</source>
        <translation>Modèle de commande&#xa0;: comment la commande transforme la trajectoire en mouvement</translation>
    </message>
    <message>
        <source>Contour tolerance: how far the path may leave the programmed corners</source>
        <translation>Tolérance de contour&#xa0;: écart permis entre la trajectoire et les angles programmés</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Machine</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>&amp;Tolérance</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Chosen by the language of the program. For the times of your machine choose it here.</source>
        <translation>Choisie par le langage du programme. Pour les temps de votre machine, la choisir ici.</translation>
    </message>
    <message>
        <source>&amp;Control</source>
        <translation>C&amp;ommande</translation>
    </message>
    <message>
        <source>Machine file …</source>
        <translation>Fichier machine …</translation>
    </message>
    <message>
        <source>Open a machine file of your own</source>
        <translation>Ouvrir un fichier machine à vous</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SetupEdit</name>
    <message>
        <source>machine %1</source>
        <translation>choix de machine %1</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>choix de modèle %1</translation>
    </message>
    <message>
        <source>back to the machine file</source>
        <translation>retour au fichier machine</translation>
    </message>
    <message>
        <source>contour tolerance</source>
        <translation>tolérance de contour</translation>
    </message>
    <message>
        <source>%1 in all runs</source>
        <translation>%1 dans toutes les simulations</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SetupTable</name>
    <message>
        <source>choice</source>
        <translation>choix</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>Plage&#xa0;: %1</translation>
    </message>
    <message>
        <source>Changed; the machine file has %1.</source>
        <translation>Modifié&#xa0;; le fichier indique %1.</translation>
    </message>
    <message>
        <source>Source: default of the model; the machine file gives none.</source>
        <translation>Source&#xa0;: valeur propre au modèle&#xa0;; le fichier machine n’en donne pas.</translation>
    </message>
    <message>
        <source>Assumed: %1</source>
        <translation>Supposé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Source&#xa0;: %1</translation>
    </message>
    <message>
        <source>The machine file gives no value.</source>
        <translation>Le fichier machine ne donne pas de valeur.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SetupView</name>
    <message numerus="yes">
        <source>Other settings (%n unset)</source>
        <translation>
            <numerusform>Autres réglages (%n sans valeur)</numerusform>
            <numerusform>Autres réglages (%n sans valeur)</numerusform>
        </translation>
    </message>
    <message>
        <source>Axis limits</source>
        <translation>Limites des axes</translation>
    </message>
    <message>
        <source>Control settings</source>
        <translation>Réglages de la commande</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>back to the file</source>
        <translation>revenir au fichier</translation>
    </message>
    <message>
        <source>Select a value to see what it means. Bold: changed. Italic: assumed, without a source.</source>
        <translation>Choisir une valeur pour voir ce qu’elle signifie. Gras&#xa0;: modifiée. Italique&#xa0;: supposée, aucune source ne la donne.</translation>
    </message>
    <message>
        <source>This model has no control settings.</source>
        <translation>Ce modèle ne lit aucun réglage de commande.</translation>
    </message>
    <message>
        <source>Changed from the file:</source>
        <translation>Modifié par rapport au fichier&#xa0;:</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Entraînements</translation>
    </message>
    <message>
        <source>How the axes follow their set values: position gain, feed-forward, backlash. Without a gain an axis follows exactly</source>
        <translation>Comment les axes suivent leurs consignes : gain de position, anticipation, jeu. Sans gain, un axe suit exactement</translation>
    </message>
    <message>
        <source>Drives: none</source>
        <translation>Entraînements : aucun</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Settings that have no value on this machine. Times of tool changes and spindle starts add to the cycle time; home, tool change position and part zero let moves to machine positions be drawn and timed.</source>
        <translation>Réglages sans valeur sur cette machine. Les temps de changement d’outil et de démarrage de broche s’ajoutent au temps de cycle&#xa0;; l’origine, la position de changement d’outil et le zéro pièce permettent de dessiner et de chronométrer les déplacements vers des positions machine.</translation>
    </message>
    <message>
        <source>Tool length and part zero say how X, Y and Z follow the rotary axes, the orientation tolerance how far their turns are rounded where blocks meet, and an angle of the part how it is turned in the clamping.</source>
        <translation>La longueur d’outil et le zéro pièce déterminent comment X, Y et Z suivent les axes rotatifs, la tolérance d’orientation de combien leurs rotations sont arrondies à la jonction des blocs, et un angle de la pièce comment elle est tournée dans son bridage.</translation>
    </message>
    <message>
        <source>Change all runs</source>
        <translation>Toutes les simulations</translation>
    </message>
    <message>
        <source>Changes are those of all runs, but for what the runs are compared in; off: of the current run alone</source>
        <translation>Les changements valent pour toutes les simulations, sauf ce en quoi elles sont comparées&#xa0;; sinon pour la simulation courante seule</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Toutes</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SideBySide</name>
    <message>
        <source>Two views &amp;side by side</source>
        <translation>Deux vues &amp;côte à côte</translation>
    </message>
    <message>
        <source>Another run beside the current one, with the same camera and colours</source>
        <translation>Une autre simulation à côté de la simulation courante, tournée et colorée de même</translation>
    </message>
    <message>
        <source>Ctrl+8</source>
        <translation>Ctrl+8</translation>
    </message>
    <message>
        <source>The run in the view on the right</source>
        <translation>La simulation dans la vue de droite</translation>
    </message>
    <message>
        <source>Run in the second view</source>
        <translation>Simulation dans la seconde vue</translation>
    </message>
    <message>
        <source>Duplicate the run to compare (Ctrl+D)</source>
        <translation>Dupliquez la simulation pour comparer (Ctrl+D)</translation>
    </message>
    <message>
        <source>Compare &amp;with</source>
        <translation>Comparer &amp;avec</translation>
    </message>
    <message>
        <source>The current run to the left of a draggable line, another one to the right</source>
        <translation>La simulation courante à gauche d’une ligne que l’on déplace, une autre à droite</translation>
    </message>
    <message>
        <source>Ctrl+Shift+8</source>
        <translation>Ctrl+Shift+8</translation>
    </message>
    <message>
        <source>Move the dividing line to the left</source>
        <translation>Moins de la simulation courante dans la vue partagée</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Left</source>
        <translation>Ctrl+Shift+Left</translation>
    </message>
    <message>
        <source>Move the dividing line to the right</source>
        <translation>Plus de la simulation courante dans la vue partagée</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Right</source>
        <translation>Ctrl+Shift+Right</translation>
    </message>
    <message>
        <source>The reference run for time lost and distances</source>
        <translation>La simulation à laquelle se rapportent temps perdu et distances</translation>
    </message>
    <message>
        <source>The run in the second view, or the first other run</source>
        <translation>La simulation voisine, ou la première autre</translation>
    </message>
    <message>
        <source>Split vie&amp;w</source>
        <translation>&amp;Vue partagée</translation>
    </message>
    <message>
        <source>Dividing line &amp;left</source>
        <translation>Ligne de partage à &amp;gauche</translation>
    </message>
    <message>
        <source>Dividing line ri&amp;ght</source>
        <translation>Ligne de partage à d&amp;roite</translation>
    </message>
    <message>
        <source>compared with %1</source>
        <translation>comparé à %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SlowPlacesModel</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>From %1 s to %2 s, slowest at %3 s in line %4.
%5 s lost against the programmed feed, mostly due to: %6.</source>
        <translation>De %1&#xa0;s à %2&#xa0;s, le plus lent à %3&#xa0;s, ligne %4.
%5&#xa0;s perdues par rapport à l’avance programmée, surtout par&#xa0;: %6.</translation>
    </message>
    <message>
        <source>Lost [s]</source>
        <translation>Perte [s]</translation>
    </message>
    <message>
        <source>Share [%]</source>
        <translation>Part [%]</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Slowest feed</source>
        <translation>Avance min.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SlowPlacesView</name>
    <message>
        <source>Number of places</source>
        <translation>Nombre de ralentissements</translation>
    </message>
    <message>
        <source>Slow places</source>
        <translation>Ralentissements</translation>
    </message>
    <message>
        <source>Next slow place</source>
        <translation>Ralentissement suivant</translation>
    </message>
    <message>
        <source>Previous slow place</source>
        <translation>Ralentissement précédent</translation>
    </message>
    <message>
        <source>%1 of %2 lost against the programmed feed, in %3 places</source>
        <translation>%1 sur %2 de perdu par rapport à l’avance programmée, en %3 endroits</translation>
    </message>
    <message>
        <source>Go to the next listed place that loses time</source>
        <translation>Aller au prochain endroit de la liste qui perd du temps</translation>
    </message>
    <message>
        <source>Go to the previous listed place</source>
        <translation>Revenir à l’endroit précédent de la liste</translation>
    </message>
    <message>
        <source>Number of places listed and visited by F7</source>
        <translation>Nombre de ralentissements affichés et parcourus par F7</translation>
    </message>
    <message>
        <source>Worst %1</source>
        <translation>Les %1 pires</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::SplitHandle</name>
    <message>
        <source>Drag to show more of one run or the other</source>
        <translation>Déplacer pour voir plus d’une simulation ou de l’autre</translation>
    </message>
    <message>
        <source>Dividing line between the two runs</source>
        <translation>Ligne de partage entre les deux simulations</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StartPage</name>
    <message>
        <source>Trochoidal slot</source>
        <translation>Rainure trochoïdale</translation>
    </message>
    <message>
        <source>ISO: short blocks against arcs</source>
        <translation>ISO : blocs courts ou arcs</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Poche</translation>
    </message>
    <message>
        <source>ISO: sharp and rounded corners</source>
        <translation>ISO : angles vifs et arrondis</translation>
    </message>
    <message>
        <source>Free-form surface</source>
        <translation>Surface gauche</translation>
    </message>
    <message>
        <source>ISO: 50 000 short blocks</source>
        <translation>ISO : 50 000 blocs courts</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Heidenhain: contour and holes</source>
        <translation>Heidenhain : contour et trous</translation>
    </message>
    <message>
        <source>Plate with pockets</source>
        <translation>Plaque à poches</translation>
    </message>
    <message>
        <source>Sinumerik: frames and cycles</source>
        <translation>Sinumerik : frames et cycles</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Bride</translation>
    </message>
    <message>
        <source>Fanuc: slots and drilling</source>
        <translation>Fanuc : rainures et perçage</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Page d’accueil</translation>
    </message>
    <message>
        <source>What does the control do with your program?</source>
        <translation>Que fait la commande de votre programme ?</translation>
    </message>
    <message>
        <source>Open an NC program or session …</source>
        <translation>Ouvrir un programme CN ou une session …</translation>
    </message>
    <message>
        <source>or drop a program, a session or a machine file here</source>
        <translation>ou déposer ici un programme, une session ou un fichier machine</translation>
    </message>
    <message>
        <source>What to do first</source>
        <translation>Par où commencer</translation>
    </message>
    <message>
        <source>&lt;ol style=&quot;margin-left: -24px&quot;&gt;&lt;li&gt;Open a program. Its language chooses a machine; your own: &lt;i&gt;File › Machine › Open machine file&lt;/i&gt;.&lt;/li&gt;&lt;li&gt;&lt;i&gt;Decide&lt;/i&gt; says how much time is lost, to what, and which changes would help.&lt;/li&gt;&lt;li&gt;&lt;i&gt;Compare tolerances …&lt;/i&gt; says which one to set and what it gains.&lt;/li&gt;&lt;li&gt;On paper: &lt;i&gt;File › Report&lt;/i&gt;.&lt;/li&gt;&lt;/ol&gt;</source>
        <translation>&lt;ol style=&quot;margin-left: -24px&quot;&gt;&lt;li&gt;Ouvrir un programme. Son langage choisit une machine ; la vôtre : &lt;i&gt;Fichier › Machine › Ouvrir un fichier machine&lt;/i&gt;.&lt;/li&gt;&lt;li&gt;&lt;i&gt;Décider&lt;/i&gt; dit combien de temps est perdu, à quoi, et quels changements aideraient.&lt;/li&gt;&lt;li&gt;&lt;i&gt;Comparer des tolérances …&lt;/i&gt; dit laquelle régler et ce qu’elle gagne.&lt;/li&gt;&lt;li&gt;Sur papier : &lt;i&gt;Fichier › Rapport&lt;/i&gt;.&lt;/li&gt;&lt;/ol&gt;</translation>
    </message>
    <message>
        <source>First steps in the handbook</source>
        <translation>Premiers pas dans le manuel</translation>
    </message>
    <message>
        <source>Opened recently</source>
        <translation>Ouverts récemment</translation>
    </message>
    <message>
        <source>Continue without a program (Esc)</source>
        <translation>Continuer sans programme (Échap)</translation>
    </message>
    <message>
        <source>Sample programs</source>
        <translation>Programmes d’exemple</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>No program has been opened yet</source>
        <translation>Aucun programme n’a encore été ouvert</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 (%2 min)</source>
        <translation>%1 (%2 min)</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StatusPanel</name>
    <message>
        <source>Cancel</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop the running calculation (Esc)</source>
        <translation>Arrêter ce qui est en cours (Esc)</translation>
    </message>
    <message>
        <source>Comparing runs %1 %</source>
        <translation>Comparaison %1 %</translation>
    </message>
    <message>
        <source>Show what the reader found in the program</source>
        <translation>Afficher ce que la lecture a relevé dans le programme</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 erreur</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 erreurs</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 avertissement</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 avertissements</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 remarque</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 remarques</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StudyChart</name>
    <message>
        <source>Cycle time and contour error over a setting: choose it and its range, then press Study.</source>
        <translation>Temps de cycle et erreur de contour en fonction d’un réglage : choisissez-le avec sa plage, puis pressez Étudier.</translation>
    </message>
    <message>
        <source>bound %1</source>
        <translation>borne %1</translation>
    </message>
    <message>
        <source>Largest contour error</source>
        <translation>Plus grande erreur de contour</translation>
    </message>
    <message>
        <source>, refused lines: %1</source>
        <translation>, lignes refusées&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Largest actual contour error</source>
        <translation>Plus grande erreur de contour réelle</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StudyMapPicture</name>
    <message>
        <source>no run is possible</source>
        <translation>aucune simulation possible</translation>
    </message>
    <message>
        <source>the two settings make no difference</source>
        <translation>les deux réglages ne changent rien</translation>
    </message>
    <message>
        <source>no run within %1</source>
        <translation>aucune simulation dans la limite de %1</translation>
    </message>
    <message>
        <source>%1 at %2 and %3, contour error %4</source>
        <translation>%1 à %2 et %3, erreur de contour %4</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>contour error</source>
        <translation>erreur de contour</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
    <message>
        <source>without refused lines</source>
        <translation>sans les lignes refusées</translation>
    </message>
    <message>
        <source>recommended: %1</source>
        <translation>recommandée&#xa0;: %1</translation>
    </message>
    <message>
        <source>recommended within %1: %2</source>
        <translation>recommandée dans la limite de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>recommandée</translation>
    </message>
    <message>
        <source>%1 at %2 and %3, actual contour error %4</source>
        <translation>%1 à %2 et %3, erreur de contour réelle %4</translation>
    </message>
    <message>
        <source>actual contour error</source>
        <translation>erreur de contour réelle</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StudyTable</name>
    <message>
        <source>%1 % %2</source>
        <translation>%1 % %2</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Value [%1]</source>
        <translation>Valeur [%1]</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Mainly limited by</source>
        <translation>Limitée surtout par</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>The program sends rotary axes where the machine cannot turn them.</source>
        <translation>Le programme envoie des axes rotatifs là où la machine ne peut pas les tourner.</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>hors de portée</translation>
    </message>
    <message>
        <source>Recommended: the smallest error among those within 1 % of the fastest</source>
        <translation>Recommandée&#xa0;: la plus petite erreur parmi celles à moins de 1 % de la plus rapide</translation>
    </message>
    <message>
        <source>Mean feed with rapids: executed path over cycle time without dwells</source>
        <translation>Avance moyenne, rapides compris&#xa0;: trajectoire exécutée divisée par le temps de cycle sans les pauses</translation>
    </message>
    <message>
        <source>Mean feed</source>
        <translation>Avance moyenne</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::StudyView</name>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>&amp;Logarithmique</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>É&amp;tudier</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>First value of the setting, in its unit</source>
        <translation>Première valeur du réglage, dans son unité</translation>
    </message>
    <message>
        <source>Last value of the setting, in its unit</source>
        <translation>Dernière valeur du réglage, dans son unité</translation>
    </message>
    <message>
        <source>Logarithmic steps from value to value</source>
        <translation>Rapports égaux d’une valeur à l’autre, et non des pas égaux</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Results of the study</source>
        <translation>Résultats de l’étude</translation>
    </message>
    <message>
        <source>&amp;Study a setting …</source>
        <translation>É&amp;tudier un réglage …</translation>
    </message>
    <message>
        <source>Cycle time and contour error over a range of a setting</source>
        <translation>Temps de cycle et erreur de contour sur une plage d’un réglage</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Copy the picture of the study</source>
        <translation>Copier l’image de l’étude</translation>
    </message>
    <message>
        <source>Save the study as CSV …</source>
        <translation>Enregistrer l’étude en CSV …</translation>
    </message>
    <message>
        <source>The numbers, one row per run</source>
        <translation>Les valeurs, une ligne par simulation</translation>
    </message>
    <message>
        <source>There is no study to save: run one first.</source>
        <translation>Il n’y a pas encore d’étude à enregistrer.</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>Enregistrer l’étude</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 ne peut pas être écrit : %2.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Open a program first.</source>
        <translation>Ouvrez d’abord un programme.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Simulating %1 runs …</source>
        <translation>Simulation de %1 valeurs …</translation>
    </message>
    <message>
        <source>Which value of a setting is the fastest, and what contour error does it cause?</source>
        <translation>Quelle valeur d’un réglage est la plus rapide, et que coûte-t-elle en erreur de contour ?</translation>
    </message>
    <message>
        <source>At the first value %1, at the last %2.</source>
        <translation>À la première valeur %1, à la dernière %2.</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation>La plus rapide</translation>
    </message>
    <message>
        <source>No value keeps the contour error within %1.</source>
        <translation>Aucune valeur ne respecte la limite de %1.</translation>
    </message>
    <message>
        <source>Fastest within %1</source>
        <translation>La plus rapide à %1 près</translation>
    </message>
    <message>
        <source>%1: %2 %3 with %4, contour error %5. %6</source>
        <translation>%1&#xa0;: %2 %3 avec %4, erreur de contour %5. %6</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Nombre de valeurs</translation>
    </message>
    <message>
        <source>Only runs with a contour error within this bound are considered for the fastest</source>
        <translation>Seules les simulations dont l’erreur de contour respecte cette borne sont prises en compte pour la plus rapide</translation>
    </message>
    <message>
        <source>Setting to vary</source>
        <translation>Réglage à faire varier</translation>
    </message>
    <message>
        <source>Add a run with the selected value</source>
        <translation>Ajouter une simulation avec la valeur choisie</translation>
    </message>
    <message>
        <source>Copy the curves of the study to the clipboard</source>
        <translation>Copier les courbes de l’étude dans le presse-papiers</translation>
    </message>
    <message>
        <source>Ma&amp;x. error</source>
        <translation>Erreur ma&amp;x.</translation>
    </message>
    <message>
        <source>&amp;Create run</source>
        <translation>&amp;Créer une simulation</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>The control refuses the program: none of its feed motions is run.</source>
        <translation>La commande refuse le programme : aucun de ses déplacements en avance n’est exécuté.</translation>
    </message>
    <message>
        <source>Lines that the control refuses and that are not run: %1.</source>
        <translation>Lignes que la commande refuse et qui ne sont pas exécutées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 makes no difference to the cycle time: %2 with every value. %3</source>
        <translation>%1 est sans effet sur le temps de cycle&#xa0;: %2 avec chaque valeur. %3</translation>
    </message>
    <message>
        <source>No run is possible: the program sends rotary axes where the machine cannot turn them.</source>
        <translation>Aucune simulation n’est possible : le programme envoie des axes rotatifs là où la machine ne peut pas les tourner.</translation>
    </message>
    <message>
        <source>no possible run</source>
        <translation>aucune simulation possible</translation>
    </message>
    <message>
        <source>%1: %2 %3 with %4, actual contour error %5. %6</source>
        <translation>%1&#xa0;: %2 %3 avec %4, erreur de contour réelle %5. %6</translation>
    </message>
    <message>
        <source>Recommended</source>
        <translation>Recommandée</translation>
    </message>
    <message>
        <source>Recommended within %1</source>
        <translation>Recommandée dans la limite de %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TestProgramDialog</name>
    <message>
        <source>&amp;Write program …</source>
        <translation>É&amp;crire le programme …</translation>
    </message>
    <message>
        <source>&amp;Open it here</source>
        <translation>&amp;L’ouvrir ici</translation>
    </message>
    <message>
        <source>Test program</source>
        <translation>Programme d’essai</translation>
    </message>
    <message>
        <source>The program keeps to this square in X and Y about the zero point</source>
        <translation>Le programme reste dans ce carré en X et Y autour de l’origine</translation>
    </message>
    <message>
        <source>As fast as the machine may feed: only rapids show higher velocities, if anything does</source>
        <translation>Aussi vite que la machine peut avancer&#xa0;: au-delà, seuls les déplacements rapides peuvent révéler des vitesses</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>What a recording of it tells</source>
        <translation>Ce que son enregistrement révèle</translation>
    </message>
    <message>
        <source>Parts of the test program</source>
        <translation>Parties du programme d’essai</translation>
    </message>
    <message>
        <source>Opens the program that was written, to lay its trace beside it</source>
        <translation>Ouvre le programme écrit, pour mettre sa trace à côté</translation>
    </message>
    <message>
        <source>&amp;Control</source>
        <translation>C&amp;ommande</translation>
    </message>
    <message>
        <source>&amp;Side of the square</source>
        <translation>Cô&amp;té du carré</translation>
    </message>
    <message>
        <source>Largest &amp;feed</source>
        <translation>Plus grande &amp;avance</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Put the zero point in the middle of a free square of %1 with nothing below or around the tool: Z goes up from it by %2, never below. Controls of Fanuc and SINUMERIK take the times of its %3 sections themselves; the others need a trace.</source>
        <translation>Placer l’origine au milieu d’un carré libre de %1, sans rien sous l’outil ni autour&#xa0;: Z monte de %2 à partir d’elle, jamais en dessous. Les commandes Fanuc et SINUMERIK prennent elles-mêmes les temps de ses %3 sections&#xa0;; les autres demandent une trace.</translation>
    </message>
    <message>
        <source>Write the test program</source>
        <translation>Écrire le programme d’essai</translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.gcode *.mpf *.h);;All files (*)</source>
        <translation>Programmes CN (*.nc *.ngc *.gcode *.mpf *.h);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 is written. Run it on the machine, record X, Y and Z meanwhile, open it here and then the trace.</source>
        <translation>%1 est écrit. Le faire tourner sur la machine, enregistrer X, Y et Z pendant ce temps, l’ouvrir ici, puis la trace.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>On %1</source>
        <translation>Sur %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TimeView</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Try changes</source>
        <translation>Essayer des changements</translation>
    </message>
    <message>
        <source>New run with this change</source>
        <translation>Simuler avec ce changement</translation>
    </message>
    <message>
        <source>Where the time goes</source>
        <translation>Où passe le temps</translation>
    </message>
    <message>
        <source>Where does the time go? Try changes</source>
        <translation>Où passe le temps ? Essayer des changements</translation>
    </message>
    <message>
        <source>Simulate what would help the whole program, each change separately</source>
        <translation>Simule ce qui aiderait tout le programme, chaque changement séparément</translation>
    </message>
    <message>
        <source>Ctrl+Shift+W</source>
        <translation>Ctrl+Shift+W</translation>
    </message>
    <message>
        <source>New run with the chosen change</source>
        <translation>Nouvelle simulation avec le changement choisi</translation>
    </message>
    <message>
        <source>Make a run of the change that is chosen under Time</source>
        <translation>Crée une simulation avec le changement choisi sous Temps</translation>
    </message>
    <message>
        <source>Open a program to see where its time goes.</source>
        <translation>Ouvrir un programme pour voir où passe son temps.</translation>
    </message>
    <message>
        <source>Looking where the time goes …</source>
        <translation>Recherche où passe le temps …</translation>
    </message>
    <message>
        <source>Simulating what would help …</source>
        <translation>Simulation des remèdes …</translation>
    </message>
    <message>
        <source>Report …</source>
        <translation>Rapport …</translation>
    </message>
    <message>
        <source>All of this as a page of a report</source>
        <translation>Tout ceci en page d’un rapport</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TraceImportDialog</name>
    <message>
        <source>&amp;Keep as …</source>
        <translation>&amp;Garder sous …</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Oublier</translation>
    </message>
    <message>
        <source>Import trace</source>
        <translation>Importer une trace</translation>
    </message>
    <message>
        <source>What are the columns of %1?</source>
        <translation>Que contiennent les colonnes de %1&#xa0;?</translation>
    </message>
    <message>
        <source>%1: %2. What are its columns?</source>
        <translation>%1&#xa0;: %2. Que contiennent ses colonnes&#xa0;?</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Keep what is chosen under a name, for other traces of this kind</source>
        <translation>Garder ce choix sous un nom, pour d’autres traces de ce type</translation>
    </message>
    <message>
        <source>Remove this preset from the list</source>
        <translation>Retirer ce préréglage de la liste</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>Premières lignes du fichier</translation>
    </message>
    <message>
        <source>&amp;Preset:</source>
        <translation>&amp;Préréglage&#xa0;:</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Nothing is chosen: there is nothing to keep.</source>
        <translation>Rien n’est choisi&#xa0;: il n’y a rien à garder.</translation>
    </message>
    <message>
        <source>Choose another name: it is empty, or that of a preset of the program.</source>
        <translation>Choisir un autre nom&#xa0;: il est vide, ou celui d’un préréglage du programme.</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Nom du préréglage&#xa0;:</translation>
    </message>
    <message>
        <source>Keep preset</source>
        <translation>Garder le préréglage</translation>
    </message>
    <message>
        <source>One sample each %1 ms</source>
        <translation>Un échantillon toutes les %1 ms</translation>
    </message>
    <message>
        <source>One sample each servo period of the machine</source>
        <translation>Un échantillon par période d’asservissement de la machine</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>In the first %1 samples: %2.</source>
        <translation>Dans les %1 premiers échantillons&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TraceImportFields</name>
    <message>
        <source>found</source>
        <translation>trouvé</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>virgule</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>point-virgule</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulation</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>espaces</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>from the times or the machine</source>
        <translation>selon les temps ou la machine</translation>
    </message>
    <message>
        <source>Samples a second, in place of the times of the file</source>
        <translation>Échantillons par seconde, au lieu des temps du fichier</translation>
    </message>
    <message>
        <source>Lines before the table that are not read</source>
        <translation>Lignes avant le tableau qui ne sont pas lues</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Sample number</source>
        <translation>Numéro d’échantillon</translation>
    </message>
    <message>
        <source>Program line</source>
        <translation>Ligne du programme</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Columns parted by</source>
        <translation>Colonnes séparées par</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Signe décimal</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Lines to skip</source>
        <translation>Lignes à sauter</translation>
    </message>
    <message>
        <source>found, if there is one</source>
        <translation>trouvée, s’il y en a une</translation>
    </message>
    <message>
        <source>Column of %1</source>
        <translation>Colonne de %1</translation>
    </message>
    <message>
        <source>as the title says</source>
        <translation>selon le titre</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unité de %1</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>The trace counts this axis in the other direction; needs a unit</source>
        <translation>La trace compte cet axe dans l’autre sens&#xa0;; il faut une unité</translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1 inversé</translation>
    </message>
    <message>
        <source>X actual</source>
        <translation>X réel</translation>
    </message>
    <message>
        <source>Y actual</source>
        <translation>Y réel</translation>
    </message>
    <message>
        <source>Z actual</source>
        <translation>Z réel</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Added to the position, in the unit of the column. 0: what shifts the trace is found where nearly all of it fits the path then</source>
        <translation>Ajouté à la position, dans l’unité de la colonne. 0 : ce qui décale la trace est trouvé là où elle suit alors presque toute la trajectoire</translation>
    </message>
    <message>
        <source>Offset of %1</source>
        <translation>Décalage de %1</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TraceView</name>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Trace that is shown</source>
        <translation>Trace affichée</translation>
    </message>
    <message>
        <source>Open &amp;trace …</source>
        <translation>Ouvrir une &amp;trace …</translation>
    </message>
    <message>
        <source>Lay what a control recorded beside the run: LinuxCNC halsampler, SINUMERIK trace, TwinCAT Scope or any table of samples</source>
        <translation>Placer à côté de la simulation ce qu’une commande a enregistré&#xa0;: halsampler de LinuxCNC, trace SINUMERIK, TwinCAT Scope ou un tableau d’échantillons</translation>
    </message>
    <message>
        <source>measurement oscilloscope recording machine compare real</source>
        <translation>mesure oscilloscope enregistrement machine comparer réel</translation>
    </message>
    <message>
        <source>Trace import &amp;options …</source>
        <translation>&amp;Options d’import de la trace …</translation>
    </message>
    <message>
        <source>What the columns of the trace are, with a preview</source>
        <translation>Ce que contiennent les colonnes de la trace, avec un aperçu</translation>
    </message>
    <message>
        <source>Read and compare the trace again</source>
        <translation>Relire et comparer la trace</translation>
    </message>
    <message>
        <source>After its file has changed, or the comparison was cancelled</source>
        <translation>Après un changement du fichier ou l’annulation de la comparaison</translation>
    </message>
    <message>
        <source>Save the agreement as JSON …</source>
        <translation>Enregistrer la concordance en JSON …</translation>
    </message>
    <message>
        <source>Figures, worst places and corners, as feedscope trace --json writes them</source>
        <translation>Grandeurs, pires endroits et angles, tels que feedscope trace --json les écrit</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>Retirer la trace</translation>
    </message>
    <message>
        <source>Take the trace that is shown off the list</source>
        <translation>Retirer de la liste la trace affichée</translation>
    </message>
    <message>
        <source>Figures of the agreement</source>
        <translation>Grandeurs de la concordance</translation>
    </message>
    <message>
        <source>Places where trace and run differ most</source>
        <translation>Endroits où trace et simulation diffèrent le plus</translation>
    </message>
    <message>
        <source>Corners, where trace and run differ most first</source>
        <translation>Angles, ceux où trace et simulation diffèrent le plus en premier</translation>
    </message>
    <message>
        <source>%1 is a trace: open the program that it was recorded of first.</source>
        <translation>%1 est une trace&#xa0;: ouvrir d’abord le programme dont elle est l’enregistrement.</translation>
    </message>
    <message>
        <source>Open trace</source>
        <translation>Ouvrir une trace</translation>
    </message>
    <message>
        <source>Traces (*.txt *.csv *.xml *.tsv *.dat *.log *.gz);;All files (*)</source>
        <translation>Traces (*.txt *.csv *.xml *.tsv *.dat *.log *.gz);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Drop what the control recorded onto the window, or open it here, to see how well the simulation agrees with your machine.</source>
        <translation>Déposer sur la fenêtre ce que la commande a enregistré, ou l’ouvrir ici, pour voir à quel point la simulation concorde avec votre machine.</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Read and compare the trace again to have it.</source>
        <translation>La comparaison a été annulée. Relire et comparer la trace pour l’obtenir.</translation>
    </message>
    <message>
        <source>Reading the trace and laying it beside the run …</source>
        <translation>Lecture de la trace et comparaison avec la simulation …</translation>
    </message>
    <message>
        <source>The trace is read; it waits for the run to be simulated.</source>
        <translation>La trace est lue&#xa0;; elle attend que la simulation soit faite.</translation>
    </message>
    <message>
        <source>The agreement cannot be saved yet: compare the trace with a run first.</source>
        <translation>La concordance ne peut pas encore être enregistrée&#xa0;: comparez d’abord la trace à une simulation.</translation>
    </message>
    <message>
        <source>Save the agreement</source>
        <translation>Enregistrer la concordance</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Trace %1: %2</source>
        <translation>Trace %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::TriesTable</name>
    <message>
        <source>cycle time</source>
        <translation>temps de cycle</translation>
    </message>
    <message>
        <source>Values tried</source>
        <translation>Valeurs essayées</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>change</source>
        <translation>variation</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::VersionsView</name>
    <message>
        <source>Versions</source>
        <translation>Versions</translation>
    </message>
    <message>
        <source>Older program …</source>
        <translation>Ancien programme …</translation>
    </message>
    <message>
        <source>Compare with an &amp;older program …</source>
        <translation>Comparer à un &amp;ancien programme …</translation>
    </message>
    <message>
        <source>Which stretches of the program changed, and what they cost or gain</source>
        <translation>Quels passages du programme ont changé, et ce qu’ils coûtent ou gagnent</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>version diff old new before after</source>
        <translation>version différence ancien nouveau avant après</translation>
    </message>
    <message>
        <source>Differences between two versions of the program</source>
        <translation>Différences entre deux versions du programme</translation>
    </message>
    <message>
        <source>Compare with an older program</source>
        <translation>Comparer à un ancien programme</translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;All files (*)</source>
        <translation>Programmes CN (*.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Simulating the older program …</source>
        <translation>Simulation de l’ancien programme …</translation>
    </message>
    <message>
        <source>Open a program to compare an older one with it.</source>
        <translation>Ouvrir un programme pour lui comparer un ancien.</translation>
    </message>
    <message>
        <source>Choose an older version of this program: both run on the machine, model and settings of the current run.</source>
        <translation>Choisir une ancienne version de ce programme : les deux tournent sur la machine, le modèle et les réglages de la simulation courante.</translation>
    </message>
    <message>
        <source>What became of the path</source>
        <translation>Ce que devient la trajectoire</translation>
    </message>
    <message>
        <source>Stretches</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>Ancien</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>The times differ nowhere</source>
        <translation>Les temps ne diffèrent nulle part</translation>
    </message>
    <message>
        <source>Where the times differ most</source>
        <translation>Où les temps diffèrent le plus</translation>
    </message>
    <message>
        <source>Older lines</source>
        <translation>Anciennes lignes</translation>
    </message>
    <message>
        <source>New lines</source>
        <translation>Nouvelles lignes</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>Affic&amp;hage</translation>
    </message>
    <message>
        <source>C&amp;hart range only</source>
        <translation>Plage des grap&amp;hiques seulement</translation>
    </message>
    <message>
        <source>Ctrl+9</source>
        <translation>Ctrl+9</translation>
    </message>
    <message>
        <source>Zoom the 3D view to the time range of the charts</source>
        <translation>La vue 3D montre la trajectoire entre les bords des graphiques</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>&amp;Default layout</source>
        <translation>&amp;Disposition par défaut</translation>
    </message>
    <message>
        <source>Original places and sizes of all panels</source>
        <translation>Tous les panneaux à leur place et à leur taille de départ</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Som&amp;bre</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Switch between light and dark colours</source>
        <translation>Basculer entre couleurs claires et sombres</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Lang&amp;ue</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Unités</translation>
    </message>
    <message>
        <source>&amp;Millimetres</source>
        <translation>&amp;Millimètres</translation>
    </message>
    <message>
        <source>Show numbers in mm, mm/min and m/s²</source>
        <translation>Afficher les nombres en mm, mm/min et m/s²</translation>
    </message>
    <message>
        <source>&amp;Inches</source>
        <translation>&amp;Pouces</translation>
    </message>
    <message>
        <source>Show numbers in inches; files keep their units</source>
        <translation>Afficher les nombres en pouces ; les fichiers gardent leurs unités</translation>
    </message>
    <message>
        <source>&amp;Beside the 3D view</source>
        <translation>À &amp;côté de la vue 3D</translation>
    </message>
    <message>
        <source>B&amp;elow the 3D view</source>
        <translation>S&amp;ous la vue 3D</translation>
    </message>
    <message>
        <source>&amp;Side by side</source>
        <translation>Côte à côte</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::WholeNumberBox</name>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>« %1 » n’est pas un nombre entier.</translation>
    </message>
    <message>
        <source>“%1” is not between %2 and %3.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas entre %2 et %3.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::WhyView</name>
    <message>
        <source>&amp;Previous cause</source>
        <translation>Cause &amp;précédente</translation>
    </message>
    <message>
        <source>Alt+Shift+Left</source>
        <translation>Alt+Shift+Left</translation>
    </message>
    <message>
        <source>&amp;Next cause</source>
        <translation>Cause &amp;suivante</translation>
    </message>
    <message>
        <source>Alt+Shift+Right</source>
        <translation>Alt+Shift+Right</translation>
    </message>
    <message>
        <source>&amp;Slower place ahead</source>
        <translation>Endroit plus &amp;lent à venir</translation>
    </message>
    <message>
        <source>Alt+Shift+Down</source>
        <translation>Alt+Shift+Down</translation>
    </message>
    <message>
        <source>&amp;What would help?</source>
        <translation>&amp;Quel remède&#xa0;?</translation>
    </message>
    <message>
        <source>Simulate changes of machine, control and feed, and show the time that each saves [s]</source>
        <translation>Simuler des changements de machine, de commande et d’avance, et montrer ce que chacun gagne [s]</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>New &amp;run with this change</source>
        <translation>&amp;Simuler avec ce changement</translation>
    </message>
    <message>
        <source>Changes and the time they save</source>
        <translation>Changements et ce qu’ils gagnent</translation>
    </message>
    <message>
        <source>Why here?</source>
        <translation>Pourquoi ici&#xa0;?</translation>
    </message>
    <message>
        <source>Open a program and point at a place to see what limits the feed there.</source>
        <translation>Ouvrir un programme et désigner un endroit&#xa0;: ici s’affiche ce qui empêche l’outil d’aller plus vite.</translation>
    </message>
    <message>
        <source>Line %1, %2 s: %3 of %4, %5&#xa0;%</source>
        <translation>Ligne %1, %2&#xa0;s&#xa0;: %3 sur %4, %5&#xa0;%</translation>
    </message>
    <message>
        <source>Line %1, %2 s</source>
        <translation>Ligne %1, %2&#xa0;s</translation>
    </message>
    <message>
        <source>▸ Go to line %1</source>
        <translation>▸ Aller à la ligne %1</translation>
    </message>
    <message>
        <source>◂ %1, line %2</source>
        <translation>◂ %1, ligne %2</translation>
    </message>
    <message>
        <source>▸ %1, line %2</source>
        <translation>▸ %1, ligne %2</translation>
    </message>
    <message>
        <source>What would help? Simulating …</source>
        <translation>Quel remède&#xa0;? Simulation en cours …</translation>
    </message>
    <message>
        <source>What would help, each change simulated separately:</source>
        <translation>Remèdes possibles, chacun simulé seul&#xa0;:</translation>
    </message>
    <message>
        <source>Go to the start of the previous limiting cause</source>
        <translation>Aller au début de la cause limitante précédente</translation>
    </message>
    <message>
        <source>Go to the start of the next limiting cause</source>
        <translation>Aller au début de la cause limitante suivante</translation>
    </message>
    <message>
        <source>Go to the place that the tool brakes for</source>
        <translation>Aller à l’endroit pour lequel l’outil freine</translation>
    </message>
    <message>
        <source>Create a new run with the selected change</source>
        <translation>Créer une simulation avec le changement sélectionné</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::WindowSession</name>
    <message>
        <source>Program not found</source>
        <translation>Programme introuvable</translation>
    </message>
    <message>
        <source>The session&apos;s program %1 was not found. Select its new location.</source>
        <translation>Le programme %1 de la session est introuvable. Indiquez où il se trouve.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Où est %1 ?</translation>
    </message>
    <message>
        <source>Program changed</source>
        <translation>Programme modifié</translation>
    </message>
    <message>
        <source>%1 has changed since the session was saved. Annotations may be at other places, and numbers may differ. Open it anyway?</source>
        <translation>%1 a changé depuis l’enregistrement de la session. Les annotations peuvent se trouver ailleurs et les valeurs différer. Ouvrir quand même ?</translation>
    </message>
    <message>
        <source>There is nothing to save: open a program first.</source>
        <translation>Il n’y a encore rien à enregistrer : ouvrez d’abord un programme.</translation>
    </message>
    <message>
        <source>Save session as</source>
        <translation>Enregistrer la session sous</translation>
    </message>
    <message>
        <source>Feedscope sessions (*%1)</source>
        <translation>Sessions Feedscope (*%1)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
    <message>
        <source>Save the session?</source>
        <translation>Enregistrer la session ?</translation>
    </message>
    <message>
        <source>Restore the last session?</source>
        <translation>Rétablir ce qui était ouvert ?</translation>
    </message>
    <message>
        <source>Feedscope ended unexpectedly. Restore what was open at that time (%1)?</source>
        <translation>Feedscope s’est arrêté de façon inattendue. Rétablir ce qui était ouvert alors (%1) ?</translation>
    </message>
    <message>
        <source>Session %1 is not opened: its program %2 was not found.</source>
        <translation>La session %1 n’est pas ouverte&#xa0;: son programme %2 est introuvable.</translation>
    </message>
    <message>
        <source>Session changed</source>
        <translation>Session modifiée</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Enregistrer &amp;sous …</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>É&amp;craser</translation>
    </message>
    <message>
        <source>%1 has been written by another window or program since this window opened or saved it. Save this session under another name, or overwrite what is in the file now?</source>
        <translation>%1 a été écrit par une autre fenêtre ou un autre programme depuis son ouverture ou son enregistrement ici. Enregistrer cette session sous un autre nom ou écraser le contenu actuel du fichier&#xa0;?</translation>
    </message>
    <message>
        <source>What is open cannot be kept in %1 and will be lost if Feedscope ends unexpectedly. Save the session, or make that folder writable.</source>
        <translation>Impossible de conserver ce qui est ouvert dans %1&#xa0;: ce sera perdu si Feedscope s’arrête de façon inattendue. Enregistrez la session ou autorisez l’écriture dans ce dossier.</translation>
    </message>
    <message>
        <source>Runs and annotations of %1, which a lesson has replaced in the window, have not been saved.</source>
        <translation>Les simulations et les annotations de %1, qu’une leçon a remplacées dans la fenêtre, n’ont pas été enregistrées.</translation>
    </message>
    <message>
        <source>Answers to lessons have not been saved.</source>
        <translation>Des réponses aux leçons ne sont pas enregistrées.</translation>
    </message>
    <message>
        <source>Runs, annotations, what was identified or answers to lessons with %1 have not been saved.</source>
        <translation>Des simulations, annotations, identifications ou réponses aux leçons avec %1 ne sont pas enregistrées.</translation>
    </message>
    <message>
        <source>Keep what was done in other lessons?</source>
        <translation>Garder ce qui a été fait dans d’autres leçons&#xa0;?</translation>
    </message>
    <message>
        <source>Answers or tried values of a lesson are in the window of which this session holds nothing. Keep them beside what it holds?</source>
        <translation>La fenêtre contient des réponses ou des valeurs essayées d’une leçon dont cette session ne contient rien. Les garder à côté de ce qu’elle contient&#xa0;?</translation>
    </message>
    <message>
        <source>Answers or tried values of %1 lessons are in the window of which this session holds nothing. Keep them beside what it holds?</source>
        <translation>La fenêtre contient des réponses ou des valeurs essayées de %1 leçons dont cette session ne contient rien. Les garder à côté de ce qu’elle contient&#xa0;?</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::WorkOffsetsTable</name>
    <message>
        <source>Work offsets</source>
        <translation>Décalages d’origine</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utilisation</translation>
    </message>
    <message>
        <source>from line %1, motions: %2</source>
        <translation>à partir de la ligne %1, déplacements : %2</translation>
    </message>
    <message>
        <source>%1; assumed as zero</source>
        <translation>%1 ; supposé nul</translation>
    </message>
    <message>
        <source>set here, not used by the program</source>
        <translation>défini ici, non utilisé par le programme</translation>
    </message>
    <message>
        <source>Zero point of the offset in the coordinates shown; empty: as programmed, otherwise 0</source>
        <translation>Origine du décalage dans les coordonnées affichées ; vide : selon le programme, sinon 0</translation>
    </message>
    <message>
        <source>The %1 coordinate of work offset %2, &quot;%3&quot;, is not a number from -1000000 to 1000000.</source>
        <translation>La coordonnée %1 du décalage d’origine %2, « %3 », n’est pas un nombre de -1000000 à 1000000.</translation>
    </message>
</context>
<context>
    <name>feedscope::ui::Workbench</name>
    <message>
        <source>%1 has changed and is reloaded.</source>
        <translation>%1 a changé et est relu.</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
    <message>
        <source>Reading %1 %</source>
        <translation>Lecture %1&#xa0;%</translation>
    </message>
    <message>
        <source> (run %1 of %2)</source>
        <translation> (simulation %1 sur %2)</translation>
    </message>
    <message>
        <source>Simulating %1 of %2 blocks%3</source>
        <translation>Simulation&#xa0;: %1 blocs sur %2%3</translation>
    </message>
    <message>
        <source>%1 is used: its control reads %2 programs.</source>
        <translation>%1 est utilisée : sa commande lit les programmes %2.</translation>
    </message>
</context>
<context>
    <name>texts</name>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Control model</source>
        <translation>Modèle de commande</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>an axis and its limit: X Jerk</comment>
        <translation>%2 %1</translation>
    </message>
    <message>
        <source>On %1</source>
        <comment>a machine</comment>
        <translation>Sur %1</translation>
    </message>
    <message>
        <source>: a corner blend can take longer than a narrower one or an exact stop, because it is passed at a limited speed along its whole length</source>
        <translation>&#xa0;: un raccord d’angle peut durer plus longtemps qu’un raccord plus étroit ou qu’un arrêt précis, car il est parcouru à vitesse limitée sur toute sa longueur</translation>
    </message>
    <message>
        <source>A tolerance of %1 takes %2 s longer than %3, mostly due to %4 (%5 s more)%6.</source>
        <translation>Une tolérance de %1 demande %2 s de plus que %3, surtout par %4 (%5 s de plus)%6.</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <comment>limits of axes and their value: X Y Jerk 15 m/s³</comment>
        <translation>%1 = %2 %3</translation>
    </message>
</context>
</TS>
