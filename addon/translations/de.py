# SPDX-License-Identifier: GPL-3.0-or-later
"""German.

The words of Blender's own German: Formschlüssel (shape key), Schlüsselbild (keyframe), Einzelbild (frame; on
narrow fields Bild), Treiber (driver), Modifikator, Masche (mesh), Sammlung (collection), Fläche (face), Punkt
(vertex), Startwert (seed), Voreinstellung (saved preset), Begrenzungsrahmen (bounding box), Regler (slider).

Ours, one for one thing: Prompt, Suche (search), Ergebnis (outcome), Teil (part), Box (part box), Leitmodell
(guide), Bewertung (score), Ansicht (view), Generation, Spektrum, Teilung (split), Verfahren (the preset:
standard or the paper's), zerlegen (split, take apart), Stück (piece), sperren (lock).

Prompts are English, for the guide: they, and names of the user's own, are not translated.
"""

MESSAGES = {
    # Panels and menus.
    ("Boxmorph", "Outcomes"): "Ergebnisse",
    ("Boxmorph", "Parts"): "Teile",
    ("Boxmorph", "Search"): "Suche",
    ("Boxmorph", "Guide"): "Leitmodell",
    ("Boxmorph", "Views"): "Ansichten",
    ("*", "Last Prompts"): "Letzte Prompts",
    ("*", "Prompts of the last searches"): "Prompts der letzten Suchen",
    ("*", "Outcome"): "Ergebnis",
    ("*", "More to do with an outcome"): "Was sich mit einem Ergebnis noch tun lässt",
    ("*", "Search Presets"): "Voreinstellungen der Suche",
    ("*", "Apply, save and delete settings of the search. Yours are kept with Blender's other presets"): (
        "Einstellungen der Suche anwenden, speichern und löschen. Eigene liegen bei Blenders anderen "
        "Voreinstellungen"
    ),
    # The search.
    ("Operator", "Deform to Prompt"): "Zum Prompt verformen",
    ("Operator", "Deform {} Objects to Prompt"): "{} Objekte zum Prompt verformen",
    ("Operator", "Add to Queue"): "Einreihen",
    ("Operator", "Select a Mesh Object"): "Mesh-Objekt auswählen",
    (
        "*",
        "Search a deformation of the active object that looks like the prompt, and add it as a shape "
        "key. While a search runs, the object waits for its end",
    ): (
        "Eine Verformung des aktiven Objekts suchen, die wie der Prompt aussieht, und sie als "
        "Formschlüssel hinzufügen. Läuft schon eine Suche, wartet das Objekt auf deren Ende"
    ),
    ("*", "All Selected"): "Alle ausgewählten",
    ("*", "Deform all selected mesh objects, one after another, not only the active one"): (
        "Alle ausgewählten Maschenobjekte verformen, eines nach dem anderen, nicht nur das aktive"
    ),
    ("Operator", "Cancel"): "Abbrechen",
    ("*", "Stop the search and leave the object as it was; objects that wait are not searched"): (
        "Die Suche anhalten und das Objekt lassen, wie es war; Objekte, die warten, werden nicht durchsucht"
    ),
    ("Operator", "Remove from Queue"): "Aus der Warteschlange nehmen",
    ("*", "Do not search this object"): "Dieses Objekt nicht durchsuchen",
    ("Operator", "Use Prompt"): "Prompt verwenden",
    ("*", "Type this prompt again"): "Diesen Prompt wieder eingeben",
    ("*", "Prompt"): "Prompt",
    (
        "*",
        "What the object should become, in a few words, such as: a bar stool. Names that the guide "
        "knows are suggested. Something between several: a bar stool:1, a throne:0.3",
    ): (
        "Was aus dem Objekt werden soll, in wenigen englischen Worten, etwa: a bar stool. Namen, die "
        "das Leitmodell kennt, werden vorgeschlagen. Etwas zwischen mehreren: a bar stool:1, a throne:0.3"
    ),
    ("Boxmorph", "More to the Prompt"): "Mehr zum Prompt",
    ("*", "Not"): "Nicht",
    (
        "*",
        "What the object should not look like, such as: a bench. For results that could be taken for "
        "something else. Counts half as much as the prompt; as much as you say with: a bench:0.8",
    ): (
        "Wonach das Objekt nicht aussehen soll, etwa: a bench. Für Ergebnisse, die sich für etwas anderes "
        "halten ließen. Zählt halb so viel wie der Prompt; so viel, wie angegeben, mit: a bench:0.8"
    ),
    ("*", "From"): "Von",
    (
        "*",
        "What the object is now, such as: a chair. What it shares with the prompt then does not count, only "
        "the way from one to the other. For changes that are too mild",
    ): (
        "Was das Objekt jetzt ist, etwa: a chair. Was es mit dem Prompt gemeinsam hat, zählt dann nicht, nur "
        "der Weg vom einen zum anderen. Für zu zaghafte Änderungen"
    ),
    ("*", "Templates"): "Vorlagen",
    (
        "*",
        "How the guide reads the texts. CLIP and its kin judge best by captions of pictures, the embedded "
        "guide by bare names",
    ): (
        "Wie das Leitmodell die Texte liest. CLIP und seine Verwandten urteilen am besten nach "
        "Bildunterschriften, das mitgelieferte nach bloßen Namen"
    ),
    ("*", "As photo and as rendering for a guide that knows any words; as typed for others"): (
        "Als Foto und als gerendertes Bild, wenn das Leitmodell alle Wörter kennt; sonst wie eingegeben"
    ),
    ("*", "On"): "Ein",
    ("*", "Read every text as a photo, a rendering and a grey 3D model of it, and take the mean"): (
        "Jeden Text als Foto, als gerendertes Bild und als graues 3D-Modell davon lesen und mitteln"
    ),
    ("*", "Read every text as it is typed"): "Jeden Text lesen, wie er eingegeben ist",
    ("Boxmorph", "Preset"): "Verfahren",
    ("*", "How thoroughly to search. Draft to try prompts out, Best for what is to be kept"): (
        "Wie gründlich gesucht wird. Entwurf, um Beschreibungen zu erproben, Bestes für das, was bleiben soll"
    ),
    ("Boxmorph", "Draft"): "Entwurf",
    ("*", "A first look, in a third of the time of Standard"): (
        "Ein erster Blick, in einem Drittel der Zeit von Standard"
    ),
    ("Boxmorph", "Standard"): "Standard",
    ("*", "A good outcome in seconds"): "Ein gutes Ergebnis in Sekunden",
    ("Boxmorph", "Best"): "Bestes",
    ("*", "Looks at more beginnings and goes on for longer, five times the time of Standard"): (
        "Erwägt mehr Anfänge und sucht länger, in der fünffachen Zeit von Standard"
    ),
    ("Boxmorph", "Time"): "Zeit",
    ("*", "The best that can be found in the seconds that you give it"): (
        "Das Beste, was sich in den vorgegebenen Sekunden finden lässt"
    ),
    ("Boxmorph", "Paper"): "Veröffentlichung",
    ("*", "The published protocol, step by step. Much slower, to compare with"): (
        "Das veröffentlichte Verfahren, Schritt für Schritt. Viel langsamer, zum Vergleich"
    ),
    ("*", "Seconds"): "Sekunden",
    (
        "*",
        "How long to search, with the preset Time. What is found depends on how fast this machine is; the "
        "record says what repeats it elsewhere",
    ): (
        "Wie lange mit dem Verfahren Zeit gesucht wird. Was dabei herauskommt, hängt davon ab, wie schnell "
        "dieser Rechner ist; das Protokoll nennt, was es anderswo wiederholt"
    ),
    ("*", "Seed"): "Startwert",
    (
        "*",
        "Change it where a result does not please: another seed gives another result, the same seed "
        "the same one again",
    ): (
        "Ändern, wo ein Ergebnis nicht gefällt: ein anderer Startwert gibt ein anderes Ergebnis, "
        "derselbe wieder dasselbe"
    ),
    # The settings of the search.
    ("*", "Splits"): "Teilungen",
    (
        "*",
        "How finely to split the object into parts. Raise it where what should change is no part of "
        "its own, lower it where parts are slivers",
    ): (
        "Wie fein das Objekt in Teile zerlegt wird. Erhöhen, wo das, was sich ändern soll, kein "
        "eigener Teil ist; verringern, wo Teile nur Splitter sind"
    ),
    ("*", "Automatic"): "Automatisch",
    ("*", "Try several and keep the best"): "Mehrere versuchen und das beste behalten",
    ("*", "Split the object into parts 1 time"): "Das Objekt 1-mal in Teile zerlegen",
    **{
        ("*", f"Split the object into parts {n} times"): f"Das Objekt {n}-mal in Teile zerlegen"
        for n in range(2, 9)
    },
    ("*", "Symmetry"): "Symmetrie",
    ("*", "Which mirror symmetry to keep. Choose None where the two sides may come to differ"): (
        "Welche Spiegelsymmetrie bleibt. „Keine“ wählen, wo die beiden Seiten verschieden werden dürfen"
    ),
    ("*", "Use the mirror symmetry found in the object, if there is one"): (
        "Die Spiegelsymmetrie, die sich im Objekt findet, wenn es eine hat"
    ),
    ("*", "None"): "Keine",
    ("*", "Let the two sides change separately"): "Die beiden Seiten ändern sich unabhängig",
    ("*", "Keep left and right alike"): "Links und rechts bleiben gleich",
    ("*", "Keep front and back alike"): "Vorn und hinten bleiben gleich",
    ("*", "Keep top and bottom alike"): "Oben und unten bleiben gleich",
    ("*", "X and Y"): "X und Y",
    ("*", "Keep left and right alike, and front and back"): (
        "Links und rechts bleiben gleich, ebenso vorn und hinten"
    ),
    ("*", "Keep"): "Beibehalten",
    (
        "*",
        "Which size of the object the result keeps. Choose one where it must fit: Height for what "
        "stands under something, Footprint for what has its place on the floor",
    ): (
        "Welche Größe des Objekts das Ergebnis behält. Wählen, wo es passen muss: „Höhe“ für das, "
        "was unter etwas steht, „Standfläche“ für das, was seinen Platz am Boden hat"
    ),
    ("*", "Keep the diagonal of the bounding box; where parts are locked, keep their size"): (
        "Die Diagonale des Begrenzungsrahmens beibehalten; wo Teile gesperrt sind, deren Größe"
    ),
    ("*", "Diagonal"): "Diagonal",
    ("*", "Keep the diagonal of the bounding box"): ("Die Diagonale des Begrenzungsrahmens beibehalten"),
    ("*", "Height"): "Höhe",
    ("*", "Keep the height"): "Die Höhe beibehalten",
    ("*", "Footprint"): "Standfläche",
    ("*", "Keep the diagonal of the rectangle on the floor"): (
        "Die Diagonale des Rechtecks am Boden beibehalten"
    ),
    ("*", "Off"): "Aus",
    ("*", "Leave the size as the search finds it"): "Die Größe lassen, wie die Suche sie findet",
    ("*", "Least Scale"): "Mindestmaß",
    (
        "*",
        "No part gets smaller than this share of its size, before the size of the whole is kept. "
        "Raise it where parts come out too thin",
    ): (
        "Kein Teil wird kleiner als dieser Anteil seiner Größe, bevor die Größe des Ganzen "
        "angeglichen wird. Erhöhen, wo Teile zu dünn werden"
    ),
    ("*", "Greatest"): "Höchstmaß",
    (
        "*",
        "No part gets larger than this many times its size, before the size of the whole is kept. "
        "Lower it to stay near the object, raise it for what is far from it",
    ): (
        "Kein Teil wird größer als dieses Vielfache seiner Größe, bevor die Größe des Ganzen "
        "angeglichen wird. Verringern, um nahe am Objekt zu bleiben; erhöhen für das, was fern von "
        "ihm ist"
    ),
    ("*", "Shift Parts"): "Teile verschieben",
    (
        "*",
        "Let parts also slide over those they hang on: legs outwards, wings back. More can be "
        "reached, and the search is less sure to find it",
    ): (
        "Teile auch über die gleiten lassen, an denen sie hängen: Beine nach außen, Flügel nach "
        "hinten. Mehr ist erreichbar, und die Suche findet es weniger sicher"
    ),
    ("*", "Variations"): "Variationen",
    (
        "*",
        "How many outcomes to make: the best, and others that are nearly as good and look different. "
        "Each takes about a third as long again",
    ): (
        "Wie viele Ergebnisse entstehen: das beste und andere, die fast so gut sind und anders "
        "aussehen. Jedes braucht etwa ein Drittel der Zeit dazu"
    ),
    ("Operator", "Add Search Preset"): "Voreinstellung der Suche hinzufügen",
    ("*", "Save the settings of the search as a preset, or delete one"): (
        "Die Einstellungen der Suche als Voreinstellung speichern oder eine löschen"
    ),
    # The running search.
    ("*", "Boxmorph: {}   Esc: Cancel"): "Boxmorph: {}   Esc: Abbrechen",
    ("*", "Waiting"): "Wartet",
    ("*", "Reading the prompt"): "Liest den Prompt",
    ("*", "Finding the parts"): "Sucht die Teile",
    ("*", "Searching with {} part boxes"): "Sucht mit {} Boxen",
    ("*", "Searching variations"): "Sucht Variationen",
    ("*", "Done"): "Fertig",
    ("*", "Generation {}"): "Generation {}",
    ("*", "Generation {} of {}"): "Generation {} von {}",
    ("*", "Score {}"): "Bewertung {}",
    ("*", "{:.0f} s left"): "noch {:.0f} s",
    ("*", "{:.0f} min left"): "noch {:.0f} min",
    # Parts.
    ("Operator", "Find Parts"): "Teile finden",
    ("Operator", "Find Again"): "Neu finden",
    ("*", "Split the active object into parts, to see them and to lock what must not change"): (
        "Das aktive Objekt in Teile zerlegen, um sie zu sehen und zu sperren, was sich nicht ändern darf"
    ),
    ("Operator", "Forget Parts"): "Teile vergessen",
    (
        "*",
        "Forget the parts of the active object and their locks, so that the search splits it as it likes",
    ): (
        "Die Teile des aktiven Objekts und ihre Sperren vergessen, so dass die Suche es zerlegt, wie sie will"
    ),
    ("Operator", "Lock Part"): "Teil sperren",
    ("*", "Keep the part's size on all axes in searches from now on, or unlock it again"): (
        "Die Größe des Teils in künftigen Suchen auf allen Achsen beibehalten, oder ihn wieder entsperren"
    ),
    ("*", "Part"): "Teil",
    ("*", "The part that is chosen in the list"): "Der Teil, der in der Liste gewählt ist",
    ("*", "Lock"): "Sperre",
    ("*", "Keep the part's size along this axis of the object, in searches from now on"): (
        "Die Größe des Teils entlang dieser Achse des Objekts in künftigen Suchen beibehalten"
    ),
    ("*", "Color"): "Farbe",
    ("*", "Color of the part's boxes"): "Farbe der Boxen des Teils",
    ("*", "Boxes"): "Boxen",
    (
        "*",
        "A collection of cubes that stand around the parts, to be used as they are; empty: the parts "
        "are found. For an object that is split otherwise than you would",
    ): (
        "Eine Sammlung von Würfeln, die um die Teile stehen und so verwendet werden; leer: die Teile "
        "werden gesucht. Für ein Objekt, das anders zerlegt wird, als man selbst es täte"
    ),
    ("*", "Show Parts"): "Teile anzeigen",
    ("*", "Draw the parts of the active object as boxes, joined where they hang together"): (
        "Die Teile des aktiven Objekts als Boxen zeichnen, verbunden, wo sie zusammenhängen"
    ),
    ("Operator", "Refine at Part Boundaries"): "An Teilgrenzen verfeinern",
    (
        "*",
        "Cut the faces of the active object that span two parts, close to the boundary on either "
        "side, so that they need not shear. UVs, materials and shape keys stay",
    ): (
        "Die Flächen des aktiven Objekts, die über zwei Teile reichen, beiderseits nahe der Grenze "
        "zerschneiden, so dass sie nicht scheren müssen. UVs, Materialien und Formschlüssel bleiben"
    ),
    ("*", "1 long face spans parts"): "1 lange Fläche über Teilgrenzen",
    ("*", "{} long faces span parts"): "{} lange Flächen über Teilgrenzen",
    ("*", "it is sheared by {:.0f}°"): "sie schert um {:.0f}°",
    ("*", "the worst is sheared by {:.0f}°"): "die schlimmste schert um {:.0f}°",
    # Outcomes.
    ("*", "{:.1f} away"): "{:.1f} weg",
    ("*", "beyond {:.1f}"): "darüber {:.1f}",
    ("*", "Taken apart: {} pieces"): "Zerlegt: {} Stücke",
    ("*", "The active object has no outcome yet. Deform it to a prompt first"): (
        "Das aktive Objekt hat noch kein Ergebnis. Erst zu einem Prompt verformen"
    ),
    ("Operator", "Again with Another Seed"): "Erneut mit anderem Startwert",
    (
        "*",
        "Search again with the outcome's own prompt and settings and the next seed. What is found "
        "takes its place",
    ): (
        "Noch einmal suchen, mit Prompt und Einstellungen des Ergebnisses und dem nächsten "
        "Startwert. Was gefunden wird, tritt an seine Stelle"
    ),
    ("Operator", "Variations"): "Variationen",
    (
        "*",
        "Search again for the prompt of this outcome, and add others that are nearly as good and "
        "look different, each as a shape key. They take the place of its earlier variations",
    ): (
        "Noch einmal nach dem Prompt dieses Ergebnisses suchen und andere hinzufügen, die fast so "
        "gut sind und anders aussehen, jedes als Formschlüssel. Sie treten an die Stelle seiner "
        "früheren Variationen"
    ),
    ("*", "Count"): "Anzahl",
    ("*", "Outcomes in all, with the one there is"): ("Ergebnisse insgesamt, mit dem, das es schon gibt"),
    ("Operator", "Show Only This"): "Nur dieses zeigen",
    ("*", "Set this outcome to 1 and all others of the object to 0"): (
        "Dieses Ergebnis auf 1 setzen und alle anderen des Objekts auf 0"
    ),
    ("Operator", "Take Apart"): "Zerlegen",
    (
        "*",
        "Make a shape key of each part's width, depth and height, to be tuned by hand. Together they "
        "equal the outcome, which is set to 0 and stays",
    ): (
        "Aus Breite, Tiefe und Höhe jedes Teils einen Formschlüssel machen, von Hand einzustellen. "
        "Zusammen ergeben sie das Ergebnis, das auf 0 gesetzt wird und bleibt"
    ),
    ("Operator", "Put Together"): "Zusammensetzen",
    (
        "*",
        "Delete the shape keys that the outcome was taken apart into, and show the outcome again as "
        "it was. What was tuned by hand on them is lost",
    ): (
        "Die Formschlüssel löschen, in die das Ergebnis zerlegt wurde, und es wieder zeigen, wie es "
        "war. Was an ihnen von Hand eingestellt wurde, geht verloren"
    ),
    ("Operator", "Add Driver Control"): "Treiber-Steuerung hinzufügen",
    (
        "*",
        "Make a custom property of the object that drives the outcome: a slider that can be keyed, "
        "driven by bones, or read by other drivers",
    ): (
        "Eine benutzerdefinierte Eigenschaft des Objekts anlegen, die das Ergebnis treibt: einen "
        "Regler, der Schlüsselbilder nimmt, von Knochen getrieben oder von anderen Treibern gelesen "
        "werden kann"
    ),
    ("Operator", "Apply as New Object"): "Als neues Objekt anwenden",
    (
        "*",
        "Make a new object, in the same place, whose mesh is the outcome as it is shown now, without "
        "shape keys. UVs, materials, groups and modifiers stay",
    ): (
        "Ein neues Objekt an derselben Stelle anlegen, dessen Masche das Ergebnis ist, wie es jetzt "
        "zu sehen ist, ohne Formschlüssel. UVs, Materialien, Gruppen und Modifikatoren bleiben"
    ),
    ("Operator", "Remove Outcome"): "Ergebnis entfernen",
    (
        "*",
        "Delete the outcome: its shape key, those it was taken apart into, its record, its control "
        "and its animation",
    ): (
        "Das Ergebnis löschen: seinen Formschlüssel, die, in die es zerlegt wurde, seine "
        "Aufzeichnung, seine Steuerung und seine Animation"
    ),
    ("Operator", "Mix Outcomes"): "Ergebnisse mischen",
    (
        "*",
        "Mix the outcomes in the ratio of their sliders, evenly where all are at 0, and no farther "
        "than every part stays thick enough",
    ): (
        "Die Ergebnisse im Verhältnis ihrer Regler mischen, gleichmäßig, wo alle auf 0 stehen, und "
        "nur so weit, dass jeder Teil dick genug bleibt"
    ),
    ("*", "Amount"): "Menge",
    (
        "*",
        "What the sliders add up to: 1 mixes whole outcomes, less stays nearer to the object, more "
        "goes beyond them",
    ): (
        "Die Summe der Regler: 1 mischt ganze Ergebnisse, weniger bleibt näher am Objekt, mehr geht "
        "über sie hinaus"
    ),
    ("Operator", "Keyframe Mix"): "Mischung als Schlüsselbild",
    (
        "*",
        "Keyframe the sliders of all outcomes as they are at the current frame. Between two mixes, "
        "all values run along straight lines",
    ): (
        "Für die Regler aller Ergebnisse, wie sie stehen, Schlüsselbilder im aktuellen Einzelbild "
        "einfügen. Zwischen zwei Mischungen laufen alle Werte auf geraden Linien"
    ),
    ("*", "Together, a part gets too thin"): "Zusammen wird ein Teil zu dünn",
    # Animation.
    ("Operator", "Keyframe Spectrum"): "Spektrum als Schlüsselbilder",
    ("*", "Animate the outcome: keyframe its value from one frame to another, as set above the button"): (
        "Das Ergebnis animieren: Schlüsselbilder für seinen Wert von einem Einzelbild zum anderen, "
        "wie über dem Knopf eingestellt"
    ),
    ("*", "Frame"): "Einzelbild",
    ("*", "Value"): "Wert",
    ("*", "to"): "bis",
    ("*", "From Frame"): "Von Bild",
    ("*", "Frame of the first keyframe"): "Einzelbild des ersten Schlüsselbilds",
    ("*", "Frame of the first keyframe: the animation starts here"): (
        "Einzelbild des ersten Schlüsselbilds: hier beginnt die Animation"
    ),
    ("*", "To Frame"): "Bis Bild",
    ("*", "Frame of the last keyframe"): "Einzelbild des letzten Schlüsselbilds",
    ("*", "Frame of the last keyframe: the animation ends here"): (
        "Einzelbild des letzten Schlüsselbilds: hier endet die Animation"
    ),
    ("*", "From Value"): "Von Wert",
    ("*", "Value at the first frame"): "Wert im ersten Einzelbild",
    (
        "*",
        "Slider value at the first frame: 0 is the object as it was, 1 the prompt, below 0 away from it",
    ): (
        "Wert des Reglers im ersten Einzelbild: 0 ist das Objekt, wie es war, 1 der Prompt, unter 0 "
        "von ihm fort"
    ),
    ("*", "To Value"): "Bis Wert",
    ("*", "Value at the last frame"): "Wert im letzten Einzelbild",
    ("*", "Slider value at the second frame: 1 is the prompt, above 1 beyond it"): (
        "Wert des Reglers im zweiten Einzelbild: 1 ist der Prompt, über 1 geht es über ihn hinaus"
    ),
    ("*", "Timing"): "Zeitverlauf",
    (
        "*",
        "How the outcome comes about between the two frames. Choose another where it starts or ends "
        "too suddenly",
    ): (
        "Wie das Ergebnis zwischen den beiden Einzelbildern entsteht. Anders wählen, wo es zu "
        "plötzlich beginnt oder endet"
    ),
    ("*", "Linear"): "Linear",
    ("*", "The value changes evenly"): "Der Wert ändert sich gleichmäßig",
    ("*", "Eased"): "Sanft",
    ("*", "The value starts and ends slowly"): "Der Wert beginnt und endet langsam",
    ("*", "Semantic"): "Semantisch",
    ("*", "The likeness to the prompt grows evenly: keys are placed by the guide's score"): (
        "Die Ähnlichkeit mit dem Prompt wächst gleichmäßig: Schlüsselbilder liegen nach der "
        "Bewertung des Leitmodells"
    ),
    # Judging.
    ("Operator", "Measure Scores"): "Bewertungen messen",
    (
        "*",
        "Measure how much the outcome looks like its prompt from one value to another, and draw the "
        "curve: it shows where on the slider it turns into the prompt",
    ): (
        "Messen, wie sehr das Ergebnis von einem Wert zum anderen seinem Prompt gleicht, und die "
        "Kurve zeichnen: sie zeigt, wo auf dem Regler es zum Prompt wird"
    ),
    ("*", "Value where the curve begins"): "Wert, bei dem die Kurve beginnt",
    ("*", "Value where the curve ends"): "Wert, bei dem die Kurve endet",
    ("Operator", "Evaluate All…"): "Alle beurteilen…",
    (
        "*",
        "Judge all outcomes of the selected objects by numbers, and write them to files: a table, and a "
        "contact sheet with every object before and after",
    ): (
        "Alle Ergebnisse der ausgewählten Objekte nach Zahlen beurteilen und sie in Dateien schreiben: eine "
        "Tabelle und einen Kontaktbogen mit jedem Objekt vorher und nachher"
    ),
    ("*", "Table"): "Tabelle",
    ("*", "Write a .csv file, a line for each outcome, for spreadsheets"): (
        "Eine .csv-Datei schreiben, eine Zeile je Ergebnis, für Tabellenprogramme"
    ),
    ("*", "Details"): "Einzelheiten",
    ("*", "Write a .json file of the same name, with the averages of each prompt, for scripts"): (
        "Eine .json-Datei desselben Namens schreiben, mit den Mittelwerten je Prompt, für Skripte"
    ),
    ("*", "Contact Sheet"): "Kontaktbogen",
    ("*", "Write a .png file of the same name: each outcome before and after, with its numbers"): (
        "Eine .png-Datei desselben Namens schreiben: jedes Ergebnis vorher und nachher, mit seinen Zahlen"
    ),
    ("*", "Nothing is to be written. Turn on Table, Details or Contact Sheet"): (
        "Es soll nichts geschrieben werden. Tabelle, Einzelheiten oder Kontaktbogen einschalten"
    ),
    ("*", "{path} cannot be written. Choose another place"): (
        "{path} lässt sich nicht schreiben. Einen anderen Ort wählen"
    ),
    ("*", "1 outcome evaluated, written to {names}"): "1 Ergebnis beurteilt, geschrieben in {names}",
    ("*", "{count} outcomes evaluated, written to {names}"): (
        "{count} Ergebnisse beurteilt, geschrieben in {names}"
    ),
    ("Operator", "Evaluate"): "Beurteilen",
    (
        "*",
        "Judge the outcome by numbers: how alike it is to its prompt, how many faces cross others, "
        "how far curvature and shading changed",
    ): (
        "Das Ergebnis nach Zahlen beurteilen: wie ähnlich es seinem Prompt ist, wie viele Flächen "
        "andere durchdringen, wie sehr sich Krümmung und Schattierung geändert haben"
    ),
    ("*", "Likeness to the prompt: {:.3f} before, {:.3f} now"): (
        "Ähnlichkeit mit dem Prompt: vorher {:.3f}, jetzt {:.3f}"
    ),
    ("*", "From the front right: {:.3f} before, {:.3f} now"): (
        "Von vorn rechts: vorher {:.3f}, jetzt {:.3f}"
    ),
    ("*", "Crossing faces: {:.2%} before, {:.2%} now"): (
        "Flächen, die sich durchdringen: vorher {:.2%}, jetzt {:.2%}"
    ),
    ("*", "Crossing faces: not counted, for there are more than {:,} triangles"): (
        "Flächen, die sich durchdringen: nicht gezählt, denn es sind über {:,} Dreiecke"
    ),
    ("*", "Curvature: changed by {:.3f} radians at a vertex on average"): (
        "Krümmung: im Mittel um {:.3f} Radiant je Punkt geändert"
    ),
    ("*", "Shading: normals turned by {:.1f}° on average"): (
        "Schattierung: Normalen im Mittel um {:.1f}° gedreht"
    ),
    ("*", "Parts: scaled by {:.2f} to {:.2f}"): "Teile: um {:.2f} bis {:.2f} skaliert",
    ("Operator", "Show Views"): "Ansichten zeigen",
    (
        "*",
        "Render the four views that the guide sees of the active object as it is now, as the image "
        "Boxmorph Views. To see what is judged where a score surprises",
    ): (
        "Die vier Ansichten, die das Leitmodell vom aktiven Objekt sieht, wie es jetzt ist, als Bild "
        "„Boxmorph Views“ rendern. Um zu sehen, was beurteilt wird, wo eine Bewertung überrascht"
    ),
    # The guide and the preferences.
    ("*", "The text–image model that judges. Change it for what the embedded one does not know"): (
        "Das Text-Bild-Modell, das urteilt. Wechseln für das, was das eingebaute nicht kennt"
    ),
    ("Boxmorph", "Embedded"): "Eingebaut",
    ("*", "The small guide inside the extension: 249 names, offline, fast"): (
        "Das kleine Leitmodell in der Erweiterung: 249 Namen, offline, schnell"
    ),
    ("Boxmorph", "Folder…"): "Ordner …",
    ("*", "A guide anywhere else on the disk"): "Ein Leitmodell irgendwo sonst auf der Platte",
    ("*", "The guide in {}"): "Das Leitmodell in {}",
    ("*", "Guide Folder"): "Ordner des Leitmodells",
    ("*", "Folder of a guide (ONNX files, tokenizer and configuration). Empty: the embedded guide"): (
        "Ordner eines Leitmodells (ONNX-Dateien, Tokenizer und Konfiguration). Leer: das eingebaute "
        "Leitmodell"
    ),
    ("*", "Guides Folder"): "Ordner für Leitmodelle",
    (
        "*",
        "Folder whose sub-folders are offered as guides. Empty: one beside Blender's settings. Name "
        "another to keep large guides on another disk",
    ): (
        "Ordner, dessen Unterordner als Leitmodelle angeboten werden. Leer: einer neben Blenders "
        "Einstellungen. Einen anderen nennen, um große Leitmodelle auf einer anderen Platte zu "
        "halten"
    ),
    ("*", "{count} in it, {size}. Else only your last prompts are kept"): (
        "Darin {count}, {size}. Sonst bleiben nur Ihre letzten Prompts"
    ),
    ("*", "1 folder"): "1 Ordner",
    ("*", "{} folders"): "{} Ordner",
    ("Operator", "Open Guides Folder"): "Ordner öffnen",
    (
        "*",
        "Show the guides folder in the file manager, to put guides into it or delete them. Guides "
        "and your last prompts are all that Boxmorph keeps on the disk; it caches nothing",
    ): (
        "Den Ordner für Leitmodelle im Dateimanager zeigen, um dort Leitmodelle abzulegen oder zu "
        "löschen. Leitmodelle und Ihre letzten Prompts sind alles, was Boxmorph auf der Platte hält; "
        "einen Cache gibt es nicht"
    ),
    ("Operator", "Check Guide"): "Leitmodell prüfen",
    ("*", "Open the chosen guide again, and say what it is or why it cannot be used"): (
        "Das gewählte Leitmodell noch einmal öffnen und sagen, was es ist oder warum es nicht verwendbar ist"
    ),
    ("Operator", "Make 8-Bit Copy"): "8-Bit-Kopie anlegen",
    (
        "*",
        "Make a copy of the chosen guide whose image network calculates in eight bits, measure how far it "
        "agrees with the exact one, and choose it. Good for drafts; the exact guide stays",
    ): (
        "Eine Kopie des gewählten Leitmodells anlegen, deren Bildnetz in acht Bit rechnet, messen, wie weit "
        "sie mit dem genauen übereinstimmt, und sie wählen. Gut für Entwürfe; das genaue Leitmodell bleibt"
    ),
    ("*", "It takes about a minute for a large guide; you can work on meanwhile"): (
        "Das dauert bei einem großen Leitmodell etwa eine Minute; Sie können derweil weiterarbeiten"
    ),
    ("*", "Make Copy"): "Kopie anlegen",
    ("*", "A copy is being made. Wait for it, or cancel it first"): (
        "Es wird gerade eine Kopie angelegt. Warten Sie darauf, oder brechen Sie erst ab"
    ),
    ("Operator", "Cancel Copy"): "Kopie abbrechen",
    ("*", "Stop making the copy. Nothing of it is left"): (
        "Die Kopie nicht zu Ende bringen. Es bleibt nichts von ihr zurück"
    ),
    ("*", "8-bit copy: {phase}, {percent} %"): "8-Bit-Kopie: {phase}, {percent} %",
    ("*", "Reading the guide"): "Liest das Leitmodell",
    ("*", "Making it smaller"): "Verkleinert es",
    ("*", "Writing the copy"): "Schreibt die Kopie",
    ("*", "Opening both"): "Öffnet beide",
    ("*", "Comparing them"): "Vergleicht beide",
    ("*", "Cancelling"): "Bricht ab",
    ("*", "Interrupted; nothing of the copy is left"): "Unterbrochen; von der Kopie bleibt nichts zurück",
    ("*", "The embedded guide is fast as it is. Choose a large one first"): (
        "Das eingebaute Leitmodell ist schon schnell. Wählen Sie erst ein großes"
    ),
    ("*", "{folder} is there already. Choose that guide, or delete it first"): (
        "{folder} gibt es schon. Wählen Sie dieses Leitmodell, oder löschen Sie es zuerst"
    ),
    (
        "*",
        "{bytes} instead of {exact_bytes}, {speed:.1f} times as fast. Its embeddings agree to a cosine of "
        "{cosine:.4f}, and it puts candidates into the same order to {order:.2f} of 1",
    ): (
        "{bytes} statt {exact_bytes}, {speed:.1f}-mal so schnell. Seine Einbettungen stimmen bis auf einen "
        "Kosinus von {cosine:.4f} überein, die Reihenfolge der Kandidaten zu {order:.2f} von 1"
    ),
    ("*", "Not opened yet"): "Noch nicht geöffnet",
    ("*", "“{name}” knows {known}, sees images of {pixels} pixels"): (
        "„{name}“ kennt {known}, sieht Bilder von {pixels} Pixeln"
    ),
    ("*", "{} names"): "{} Namen",
    ("*", "any words"): "beliebige Wörter",
    ("*", "inside the extension"): "in der Erweiterung",
    ("*", "What It Runs On"): "Worauf es läuft",
    (
        "*",
        "A library of ONNX Runtime of your own, for a graphics card. Empty: the one inside the "
        "extension. Read when Blender first uses a guide",
    ): (
        "Eine eigene Bibliothek von ONNX Runtime, für eine Grafikkarte. Leer: die in der "
        "Erweiterung. Gelesen, wenn Blender zum ersten Mal ein Leitmodell verwendet"
    ),
    ("*", "ONNX Runtime {version} offers: {offered}. In use: {used}"): (
        "ONNX Runtime {version} bietet: {offered}. In Gebrauch: {used}"
    ),
    ("*", "The library named above is used once Blender starts again"): (
        "Die oben genannte Bibliothek wird verwendet, sobald Blender neu startet"
    ),
    ("*", "Provider"): "Provider",
    (
        "*",
        "What the guide encodes images on. Change it where a large guide is slow and your ONNX "
        "Runtime library has something faster. Scores then differ in the last digits",
    ): (
        "Worauf das Leitmodell Bilder kodiert. Ändern, wo ein großes Leitmodell langsam ist und die "
        "eigene ONNX-Runtime-Bibliothek etwas Schnelleres hat. Bewertungen weichen dann in den "
        "letzten Stellen ab"
    ),
    (
        "*",
        "The processor, so that results are the same everywhere; a large guide runs on the graphics "
        "card where an ONNX Runtime library of your own has one",
    ): (
        "Der Prozessor, so dass Ergebnisse überall gleich sind; ein großes Leitmodell läuft auf der "
        "Grafikkarte, wo eine eigene ONNX-Runtime-Bibliothek eine hat"
    ),
    ("*", "Processor"): "Prozessor",
    ("*", "The processor, by ONNX Runtime itself"): "Der Prozessor, durch ONNX Runtime selbst",
    ("*", "NVIDIA graphics cards, if the ONNX Runtime library has it"): (
        "NVIDIA-Grafikkarten, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Any graphics card under Windows, if the ONNX Runtime library has it"): (
        "Jede Grafikkarte unter Windows, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Apple's processors, if the ONNX Runtime library has it"): (
        "Apples Prozessoren, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "AMD graphics cards, if the ONNX Runtime library has it"): (
        "AMD-Grafikkarten, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Intel's graphics and processors, if the ONNX Runtime library has it"): (
        "Intels Grafik und Prozessoren, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Renderer"): "Renderer",
    ("*", "What renders the views that the guide sees. Change it where a driver makes trouble"): (
        "Was die Ansichten rendert, die das Leitmodell sieht. Ändern, wo ein Grafiktreiber Ärger macht"
    ),
    ("*", "The graphics card where there is a real one, else the processor"): (
        "Die Grafikkarte, wo es eine echte gibt, sonst der Prozessor"
    ),
    ("*", "Render the guide's views on the processor. Choose it where a driver makes trouble"): (
        "Die Ansichten des Leitmodells auf dem Prozessor rendern. Wählen, wo ein Grafiktreiber Ärger macht"
    ),
    ("*", "Graphics Card"): "Grafikkarte",
    ("*", "Render the guide's views on the graphics card, even one that the processor plays"): (
        "Die Ansichten des Leitmodells auf der Grafikkarte rendern, selbst auf einer, die der "
        "Prozessor spielt"
    ),
    ("*", "Threads"): "Threads",
    (
        "*",
        "Processor threads that a search may use; 0 means all. Lower it to work on meanwhile. Read "
        "when Blender first searches",
    ): (
        "Threads des Prozessors, die eine Suche verwenden darf; 0 heißt alle. Verringern, um "
        "nebenher weiterzuarbeiten. Gelesen, wenn Blender zum ersten Mal sucht"
    ),
    ("Operator", "Preferences"): "Einstellungen",
    # The report on a bug.
    ("*", "Something Is Wrong?"): "Etwas stimmt nicht?",
    ("Operator", "Copy Report"): "Bericht kopieren",
    ("Operator", "Report as Text"): "Bericht als Text",
    (
        "*",
        "Put a text on the clipboard that says what Boxmorph is doing: versions, settings, counts of "
        "the active object, what was refused last. For a report on a bug; it names no user, and "
        "nothing is sent",
    ): (
        "Einen Text in die Zwischenablage legen, der sagt, was Boxmorph tut: Versionen, "
        "Einstellungen, Zahlen zum aktiven Objekt, was zuletzt abgelehnt wurde. Für die Meldung "
        "eines Fehlers; er nennt keinen Benutzer, und nichts wird gesendet"
    ),
    ("*", "As Text"): "Als Text",
    ("*", "Put it into the text “Boxmorph Report” of this file instead, to read it first"): (
        "Ihn stattdessen in den Text „Boxmorph Report“ dieser Datei schreiben, um ihn erst zu lesen"
    ),
    # What is told of a search.
    ("*", "The guide does not know {} and goes by the other words"): (
        "Das Leitmodell kennt {} nicht und geht nach den anderen Wörtern"
    ),
    ("*", "“{word}” (nearest: “{known}”)"): "„{word}“ (am nächsten: „{known}“)",
    ("*", "Searching on the rest shape, without the modifiers {}"): (
        "Gesucht wird an der Ruheform, ohne die Modifikatoren {}"
    ),
    ("*", "{} of {} parts is locked"): "{} von {} Teilen ist gesperrt",
    ("*", "{} of {} parts are locked"): "{} von {} Teilen sind gesperrt",
    ("*", "The mesh has {} users, and all of them get the shape key"): (
        "Die Masche hat {} Nutzer, und alle erhalten den Formschlüssel"
    ),
    ("*", "{} waits for the search that runs"): "{} wartet auf die laufende Suche",
    ("*", "{} wait for the search that runs"): "{} warten auf die laufende Suche",
    ("*", "“{name}” is searched or waits already. Cancel the search with Esc to begin anew"): (
        "„{name}“ wird schon durchsucht oder wartet. Die Suche mit Esc abbrechen, um neu zu beginnen"
    ),
    ("*", "“{name}” was deleted before its search began"): (
        "„{name}“ wurde gelöscht, bevor die Suche begann"
    ),
    ("*", "Cancelled; the object is as it was"): "Abgebrochen; das Objekt ist, wie es war",
    ("*", "Cancelled by undo"): "Durch Rückgängig abgebrochen",
    ("*", "Cancelled: “{}” was deleted or its mesh was changed"): (
        "Abgebrochen: „{}“ wurde gelöscht oder seine Masche geändert"
    ),
    ("*", "The search ended in coordinates that are not numbers; nothing was changed"): (
        "Die Suche endete in Koordinaten, die keine Zahlen sind; nichts wurde geändert"
    ),
    ("*", "score {:.3f} → {:.3f} in {:.1f} s"): "Bewertung {:.3f} → {:.3f} in {:.1f} s",
    ("*", "“{}”"): "„{}“",
    ("*", "“{name}”: {scores}"): "„{name}“: {scores}",
    ("*", "“{name}”: {scores}, with {found}"): "„{name}“: {scores}, mit {found}",
    ("*", "“{name}”: {scores}, with {found} of {total}; no others are as good and look different"): (
        "„{name}“: {scores}, mit {found} von {total}; keine anderen sind so gut und sehen anders aus"
    ),
    ("*", "1 variation"): "1 Variation",
    ("*", "{} variations"): "{} Variationen",
    ("*", "Refine at Part Boundaries cuts them"): "„An Teilgrenzen verfeinern“ zerschneidet sie",
    (
        "*",
        "Under its modifier {names} the outcome differs from what was scored, {how}. Apply it and "
        "search again where that matters",
    ): (
        "Unter seinem Modifikator {names} weicht das Ergebnis von dem ab, was bewertet wurde, {how}. "
        "Wo das stört, ihn anwenden und erneut suchen"
    ),
    (
        "*",
        "Under its modifiers {names} the outcome differs from what was scored, {how}. Apply them and "
        "search again where that matters",
    ): (
        "Unter seinen Modifikatoren {names} weicht das Ergebnis von dem ab, was bewertet wurde, "
        "{how}. Wo das stört, sie anwenden und erneut suchen"
    ),
    ("*", "up to {:.2g}% of its size"): "bis zu {:.2g} % seiner Größe",
    ("*", "in the number of its vertices"): "in der Zahl seiner Punkte",
    # What is refused of an object.
    ("*", "There is no active object. Select the object to deform"): (
        "Es gibt kein aktives Objekt. Das Objekt auswählen, das verformt werden soll"
    ),
    ("*", "There is no active mesh object to view. Select one"): (
        "Es gibt kein aktives Maschenobjekt, das zu sehen wäre. Eines auswählen"
    ),
    ("*", "“{name}” is a {kind}, not a mesh. Convert it to a mesh first"): (
        "„{name}“ ({kind}) ist keine Masche. Erst in eine Masche umwandeln"
    ),
    (
        "*",
        "The mesh of “{name}” is linked from another file, where changes would be lost. Make the "
        "object and its data local first (Object > Relations > Make Local)",
    ): (
        "Die Masche von „{name}“ ist mit einer anderen Datei verknüpft, wo Änderungen verloren "
        "gingen. Erst das Objekt und seine Daten lokal machen (Object > Relations > Make Local)"
    ),
    ("*", "“{name}” is in {mode} Mode. Go to Object Mode first"): (
        "„{name}“ ist nicht im Objektmodus ({mode} Mode). Erst in den Objektmodus wechseln"
    ),
    ("*", "“{name}” is in Edit Mode. Go to Object Mode first"): (
        "„{name}“ ist im Bearbeitungsmodus. Erst in den Objektmodus wechseln"
    ),
    (
        "*",
        "“{name}” has absolute shape keys, which play one after another. Turn on Relative in its "
        "shape key panel first",
    ): (
        "„{name}“ hat absolute Formschlüssel, die nacheinander ablaufen. Erst im Bereich seiner "
        "Formschlüssel „Relativ“ einschalten"
    ),
    ("*", "The mesh of “{name}” is empty"): "Die Masche von „{name}“ ist leer",
    (
        "*",
        "“{name}” is not in the view layer “{layer}”, so its modifiers cannot be evaluated. Enable "
        "its collection first",
    ): (
        "„{name}“ ist nicht in der Ansichtsebene „{layer}“, so dass seine Modifikatoren nicht "
        "ausgewertet werden können. Erst seine Sammlung einschalten"
    ),
    (
        "*",
        "{count} of the {total} vertices of “{name}” have coordinates that are not numbers. Delete "
        "or move them first",
    ): (
        "{count} der {total} Punkte von „{name}“ haben Koordinaten, die keine Zahlen sind. Sie erst "
        "löschen oder verschieben"
    ),
    ("*", "The mesh of “{name}” has no faces, so there is nothing to see or to split"): (
        "Die Masche von „{name}“ hat keine Flächen, so dass nichts zu sehen und nichts zu zerlegen ist"
    ),
    ("*", "The faces of “{name}” have no area, so there is nothing to see or to split"): (
        "Die Flächen von „{name}“ haben keinen Inhalt, so dass nichts zu sehen und nichts zu zerlegen ist"
    ),
    (
        "*",
        "The collection “{collection}” holds no boxes. Put cubes around the parts of “{name}” into "
        "it, or clear the field",
    ): (
        "Die Sammlung „{collection}“ enthält keine Boxen. Würfel um die Teile von „{name}“ "
        "hineinlegen oder das Feld leeren"
    ),
    (
        "*",
        "“{name}” has changed since its parts were found. Find them again and check the locks, or "
        "forget them",
    ): (
        "„{name}“ hat sich geändert, seit seine Teile gefunden wurden. Sie neu finden und die "
        "Sperren prüfen, oder sie vergessen"
    ),
    ("*", "The parts of “{name}” are not known yet. Find them first"): (
        "Die Teile von „{name}“ sind noch nicht bekannt. Sie erst finden"
    ),
    ("*", "{} faces added"): "{} Flächen hinzugefügt",
    ("*", "No face spans a boundary; nothing was cut"): (
        "Keine Fläche reicht über eine Grenze; nichts wurde zerschnitten"
    ),
    # What is told and refused of outcomes.
    ("*", "“{name}” has no outcome named “{outcome}”"): ("„{name}“ hat kein Ergebnis namens „{outcome}“"),
    ("*", "“{name}” has fewer than two outcomes to mix: muted ones and those taken apart are left out"): (
        "„{name}“ hat keine zwei Ergebnisse zum Mischen: stummgeschaltete und zerlegte bleiben außen vor"
    ),
    ("*", "“{name}” is driven, so its value cannot be set. Delete its driver first, or mute it"): (
        "„{name}“ hat einen Treiber, so dass sein Wert nicht zu setzen ist. Erst den Treiber löschen "
        "oder es stummschalten"
    ),
    ("*", "“{}” is taken apart, and its pieces stay as they are"): (
        "„{}“ ist zerlegt, und seine Stücke bleiben, wie sie sind"
    ),
    ("*", "Only “{}” has a value other than 0, and it keeps that"): (
        "Nur „{}“ hat einen anderen Wert als 0, und es behält ihn"
    ),
    ("*", "There is room for an amount of {:.2f}, not {:.2f}"): (
        "Es ist Raum für eine Menge von {:.2f}, nicht {:.2f}"
    ),
    (
        "*",
        "The pieces of {names} already make a part thinner than a twentieth of itself. Put it "
        "together first, or set its pieces nearer to 0",
    ): (
        "Schon die Stücke von {names} machen einen Teil dünner als ein Zwanzigstel seiner selbst. "
        "Erst zusammensetzen oder die Stücke näher an 0 stellen"
    ),
    ("*", "“{name}” is off, so that nothing of it is seen. Give it a value first"): (
        "„{name}“ ist aus, so dass nichts davon zu sehen ist. Erst einen Wert geben"
    ),
    ("*", "“{outcome}” follows the custom property “{control}” of “{name}”"): (
        "„{outcome}“ folgt der benutzerdefinierten Eigenschaft „{control}“ von „{name}“"
    ),
    ("*", "“{name}” is driven already"): "„{name}“ hat schon einen Treiber",
    (
        "*",
        "“{name}” has keyframes, which a driver would hide. Delete them first, and key the control instead",
    ): (
        "„{name}“ hat Schlüsselbilder, die ein Treiber verdecken würde. Sie erst löschen und dann "
        "die Steuerung mit Schlüsselbildern versehen"
    ),
    ("*", "“{}” is now {} shape keys"): "„{}“ ist jetzt {} Formschlüssel",
    ("*", "{} of its shape keys, deleted or renamed, were left as they are"): (
        "{} seiner Formschlüssel, gelöscht oder umbenannt, blieben, wie sie sind"
    ),
    ("*", "“{name}” is taken apart already. Put it together first"): (
        "„{name}“ ist schon zerlegt. Erst zusammensetzen"
    ),
    ("*", "“{name}” is not taken apart"): "„{name}“ ist nicht zerlegt",
    (
        "*",
        "“{name}” is animated, and would move along with its pieces. Remove its keyframes or its "
        "driver first",
    ): (
        "„{name}“ ist animiert und würde sich mit seinen Stücken bewegen. Erst seine Schlüsselbilder "
        "oder seinen Treiber entfernen"
    ),
    ("*", "“{name}” changes nothing that could be seen, so there is nothing to take apart"): (
        "„{name}“ ändert nichts, was zu sehen wäre, so dass nichts zu zerlegen ist"
    ),
    ("*", "“{name}” has no record of its parts. Search again, then take that apart"): (
        "„{name}“ hat keine Aufzeichnung seiner Teile. Erneut suchen und dann dieses Ergebnis zerlegen"
    ),
    ("*", "The parts that “{name}” was found with have been forgotten. Find or give them again"): (
        "Die Teile, mit denen „{name}“ gefunden wurde, sind vergessen. Sie neu finden oder wieder angeben"
    ),
    (
        "*",
        "“{name}”, its parts or the shape key “{outcome}” have changed since the search, so that it "
        "cannot be told which part does what. Undo the change, or search again",
    ): (
        "„{name}“, seine Teile oder der Formschlüssel „{outcome}“ haben sich seit der Suche "
        "geändert, so dass nicht zu sagen ist, welcher Teil was bewirkt. Die Änderung rückgängig "
        "machen oder erneut suchen"
    ),
    (
        "*",
        "Under the modifiers of “{name}”, “{outcome}” has other vertices than the object, so the "
        "shapes between cannot be scored. Apply the modifiers first",
    ): (
        "Unter den Modifikatoren von „{name}“ hat „{outcome}“ andere Punkte als das Objekt, so dass "
        "die Formen dazwischen nicht zu bewerten sind. Erst die Modifikatoren anwenden"
    ),
    # What is refused of an animation.
    ("*", "The spectrum needs two different frames, and both are {frame}"): (
        "Das Spektrum braucht zwei verschiedene Einzelbilder, und beide sind {frame}"
    ),
    ("*", "The value {alpha:g} is outside of what “{name}” can be, {least:.2f} to {greatest:.2f}"): (
        "Der Wert {alpha:g} liegt außerhalb dessen, was „{name}“ sein kann, {least:.2f} bis {greatest:.2f}"
    ),
    (
        "*",
        "“{name}” is driven, and a driven value cannot be keyframed. Delete its driver first, or "
        "keyframe what drives it",
    ): (
        "„{name}“ hat einen Treiber, und ein getriebener Wert nimmt keine Schlüsselbilder. Erst den "
        "Treiber löschen oder Schlüsselbilder bei dem einfügen, was ihn treibt"
    ),
    ("*", "Blender refused a keyframe on “{name}”; its animation may be linked or locked"): (
        "Blender hat ein Schlüsselbild für „{name}“ abgelehnt; seine Animation ist vielleicht "
        "verknüpft oder gesperrt"
    ),
    (
        "*",
        "The keyframes of “{name}” are linked from another file, where changes would be lost. Make "
        "them local first (Object > Relations > Make Local > All)",
    ): (
        "Die Schlüsselbilder von „{name}“ sind mit einer anderen Datei verknüpft, wo Änderungen "
        "verloren gingen. Sie erst lokal machen (Object > Relations > Make Local > All)"
    ),
    ("*", "The animation of “{name}” is locked. Unlock its channel in the Graph Editor first"): (
        "Die Animation von „{name}“ ist gesperrt. Erst ihren Kanal im Grapheneditor entsperren"
    ),
    (
        "*",
        "The score does not rise from value {first:.3g} ({low:.3f}) to {last:.3g} ({high:.3f}), so "
        "keys cannot be placed by it. Choose other values or another timing",
    ): (
        "Die Bewertung steigt von Wert {first:.3g} ({low:.3f}) bis {last:.3g} ({high:.3f}) nicht, so "
        "dass sich Schlüsselbilder nicht nach ihr setzen lassen. Andere Werte oder einen anderen "
        "Zeitverlauf wählen"
    ),
    # What is refused of the installation and the report.
    (
        "*",
        "Boxmorph's compiled module cannot be loaded ({error}). Install the extension's zip for this "
        "operating system and processor",
    ): (
        "Boxmorphs kompiliertes Modul lässt sich nicht laden ({error}). Das Zip der Erweiterung für "
        "dieses Betriebssystem und diesen Prozessor installieren"
    ),
    (
        "*",
        "Blender has kept the compiled module of another build of Boxmorph {version}. Remove the "
        "extension, restart Blender and install it again",
    ): (
        "Blender hat das kompilierte Modul eines anderen Baus von Boxmorph {version} behalten. Die "
        "Erweiterung entfernen, Blender neu starten und sie wieder installieren"
    ),
    (
        "*",
        "Boxmorph {version} was installed while {loaded} was in use. Restart Blender to finish the update",
    ): (
        "Boxmorph {version} wurde installiert, während {loaded} in Gebrauch war. Blender neu "
        "starten, um die Aktualisierung abzuschließen"
    ),
    (
        "*",
        "This is Boxmorph {version}, but Blender has loaded the compiled module of {loaded}. Remove "
        "other copies of Boxmorph from the extensions and restart Blender",
    ): (
        "Dies ist Boxmorph {version}, aber Blender hat das kompilierte Modul von {loaded} geladen. "
        "Andere Kopien von Boxmorph aus den Erweiterungen entfernen und Blender neu starten"
    ),
    (
        "*",
        "The ONNX Runtime library {path} is missing. Correct its path in Boxmorph's preferences, or "
        "clear it to use the one inside the extension",
    ): (
        "Die ONNX-Runtime-Bibliothek {path} fehlt. Ihren Pfad in den Einstellungen von Boxmorph "
        "berichtigen oder leeren, um die in der Erweiterung zu verwenden"
    ),
    (
        "*",
        "The guide folder {folder} does not exist. Correct it in Boxmorph's preferences, or choose "
        "the embedded guide there",
    ): (
        "Den Ordner {folder} des Leitmodells gibt es nicht. Ihn in den Einstellungen von Boxmorph "
        "berichtigen oder dort das eingebaute Leitmodell wählen"
    ),
    ("*", "The folder {folder} cannot be made ({reason}). Name another"): (
        "Der Ordner {folder} lässt sich nicht anlegen ({reason}). Einen anderen nennen"
    ),
    # Guides from the hub.
    ("*", "Get a Guide"): "Ein Leitmodell holen",
    ("*", "Show the guides that can be downloaded, for prompts that the embedded one does not know"): (
        "Die Leitmodelle zeigen, die sich herunterladen lassen, für Prompts, die das eingebaute nicht kennt"
    ),
    ("*", "Hub Address"): "Adresse des Hubs",
    (
        "*",
        "Where guides are downloaded from: the address of a mirror of the Hugging Face hub. Empty: "
        "the hub itself, or what the variable HF_ENDPOINT names",
    ): (
        "Von wo Leitmodelle heruntergeladen werden: die Adresse eines Spiegels des Hubs von Hugging Face. "
        "Leer: der Hub selbst oder was die Variable HF_ENDPOINT nennt"
    ),
    ("*", "Allow Online Access"): "Onlinezugriff erlauben",
    ("*", "Online access is off. Allow it in the preferences, under System, to download guides"): (
        "Der Onlinezugriff ist aus. Ihn in den Einstellungen unter System erlauben, um Leitmodelle "
        "herunterzuladen"
    ),
    ("*", "Blender was started offline. Start it with --online-mode to download guides"): (
        "Blender wurde offline gestartet. Es mit --online-mode starten, um Leitmodelle herunterzuladen"
    ),
    ("*", "Blender does not allow online access. Start it with --online-mode"): (
        "Blender erlaubt keinen Onlinezugriff. Es mit --online-mode starten"
    ),
    ("*", "{title}: {least} to {most}, {licence}"): "{title}: {least} bis {most}, {licence}",
    ("*", "The paper's guide; the one to begin with"): "Das Leitmodell des Aufsatzes; für den Anfang",
    ("*", "Finer detail than ViT-B/32, at four times its time"): (
        "Feinere Einzelheiten als ViT-B/32, in vierfacher Zeit"
    ),
    ("*", "The best of CLIP; for a graphics card or patience"): (
        "Das Beste von CLIP; für eine Grafikkarte oder Geduldige"
    ),
    ("*", "Tells objects apart better than CLIP of its size"): (
        "Unterscheidet Gegenstände besser als ein CLIP seiner Größe"
    ),
    ("*", "Prompts in many languages"): "Prompts in vielen Sprachen",
    ("*", "Smallest and fastest; a first try of any words on a laptop"): (
        "Am kleinsten und schnellsten; um beliebige Wörter auf einem Laptop zu probieren"
    ),
    ("*", "Others report images that differ clearly from fp32's"): (
        "Andere berichten von Bildern, die deutlich von denen in fp32 abweichen"
    ),
    ("*", "Full (fp32)"): "Voll (fp32)",
    ("*", "As it was made. The fastest but int8 on a processor"): (
        "Wie es gemacht wurde. Auf einem Prozessor nach int8 das schnellste"
    ),
    ("*", "Half (fp16)"): "Halb (fp16)",
    ("*", "Half the size, practically the same scores; for graphics cards"): (
        "Halb so groß, praktisch dieselben Bewertungen; für Grafikkarten"
    ),
    ("*", "Small (int8)"): "Klein (int8)",
    ("*", "A quarter of the size, and the fastest on a processor; scores are coarser"): (
        "Ein Viertel der Größe und auf einem Prozessor am schnellsten; die Bewertungen sind gröber"
    ),
    ("*", "Precision"): "Genauigkeit",
    (
        "*",
        "How exactly the guide's numbers are kept",
    ): "Wie genau die Zahlen des Leitmodells gespeichert sind",
    ("*", "Size: about {}"): "Größe: etwa {}",
    ("*", "Licence of its weights: {}"): "Lizenz der Gewichte: {}",
    ("*", "From {repository}, {hub}"): "Von {repository}, {hub}",
    ("*", "on the hub"): "auf dem Hub",
    ("*", "Into {}"): "Nach {}",
    ("*", "Unverified: we could not check the names of its files"): (
        "Ungeprüft: Die Namen seiner Dateien konnten wir nicht prüfen"
    ),
    ("Operator", "Download"): "Herunterladen",
    ("*", "Download"): "Herunterladen",
    ("Operator", "Download Guide"): "Leitmodell herunterladen",
    (
        "*",
        "Download this guide from the hub, after a look at its size and licence. What has come stays if "
        "it is cancelled, and the next download goes on from there",
    ): (
        "Dieses Leitmodell vom Hub herunterladen, nach einem Blick auf Größe und Lizenz. Wird abgebrochen, "
        "bleibt, was angekommen ist, und das nächste Mal geht es dort weiter"
    ),
    ("Operator", "Resume ({} % here)"): "Fortsetzen ({} % da)",
    ("Operator", "Cancel Download"): "Herunterladen abbrechen",
    ("*", "Stop the download. What has come is kept, and the next download goes on from there"): (
        "Das Herunterladen anhalten. Was angekommen ist, bleibt, und das nächste Mal geht es dort weiter"
    ),
    ("Operator", "Use"): "Verwenden",
    ("Operator", "In Use"): "In Verwendung",
    ("Operator", "Use Guide"): "Leitmodell verwenden",
    ("*", "Let this guide judge from now on"): "Von jetzt an dieses Leitmodell urteilen lassen",
    ("*", "Remove"): "Entfernen",
    ("Operator", "Remove Guide"): "Leitmodell entfernen",
    ("*", "Delete this guide from the disk, or what an unfinished download of it has left"): (
        "Dieses Leitmodell von der Festplatte löschen oder was von ihm angefangen dort liegt"
    ),
    ("*", "{title}, {precision}, {size}. It can be downloaded again"): (
        "{title}, {precision}, {size}. Es lässt sich wieder herunterladen"
    ),
    ("*", "{name}: {here} of {total}"): "{name}: {here} von {total}",
    ("*", "{name}: in the hub's cache"): "{name}: im Zwischenspeicher des Hubs",
    ("*", "{name}: downloaded"): "{name}: heruntergeladen",
    ("*", "{here} of {total}"): "{here} von {total}",
    ("*", "Asking the server"): "Fragt den Server",
    ("*", "Downloading"): "Lädt herunter",
    ("*", "Checking what is here"): "Prüft, was da ist",
    ("*", "Trying again: {}"): "Versucht es noch einmal: {}",
    ("*", "Downloaded {}"): "{} heruntergeladen",
    ("*", "A guide is being downloaded. Wait for it, or cancel it first"): (
        "Ein Leitmodell wird heruntergeladen. Darauf warten oder es zuerst abbrechen"
    ),
    ("*", "The guide “{name}” is not here. Download it first"): (
        "Das Leitmodell „{name}“ ist nicht da. Es zuerst herunterladen"
    ),
    ("*", "There is no guide “{name}” to download. Choose {known}"): (
        "Es gibt kein Leitmodell „{name}“ zum Herunterladen. Zur Wahl stehen {known}"
    ),
    ("*", "There is no guide “{name}”. Choose {known}, or name a folder"): (
        "Es gibt kein Leitmodell „{name}“. Zur Wahl stehen {known}, oder ein Ordner"
    ),
    ("*", "There is no clipboard in background. Ask for the report as text"): (
        "Im Hintergrund gibt es keine Zwischenablage. Den Bericht als Text verlangen"
    ),
    ("*", "Error"): "Fehler",
    ("*", "The report is on the clipboard. Paste it where you tell of the bug"): (
        "Der Bericht ist in der Zwischenablage. Dort einfügen, wo der Fehler gemeldet wird"
    ),
    ("*", "The report is the text “{}”. Read it in a Text Editor"): (
        "Der Bericht ist der Text „{}“. In einem Texteditor zu lesen"
    ),
}
