<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>Editor</name>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Kapat</translation>
    </message>
    <message>
        <source>0: chosen from the two organs</source>
        <translation>0: iki organdan seçilir</translation>
    </message>
    <message>
        <source>A stone…</source>
        <translation>Taş…</translation>
    </message>
    <message>
        <source>Add an organ…</source>
        <translation>Organ ekle…</translation>
    </message>
    <message>
        <source>Add to the scene</source>
        <translation>Sahneye ekle</translation>
    </message>
    <message>
        <source>Being checked.</source>
        <translation>Denetleniyor.</translation>
    </message>
    <message>
        <source>Changing the scene</source>
        <translation>Sahne değiştiriliyor</translation>
    </message>
    <message>
        <source>Checking the scene</source>
        <translation>Sahne denetleniyor</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Seçilen</translation>
    </message>
    <message>
        <source>Click a part in the view or in the tree to choose it.</source>
        <translation>Seçmek için görünümde ya da ağaçta bir parçaya tıklayın.</translation>
    </message>
    <message>
        <source>Each pair is pressed together to measure it.</source>
        <translation>Ölçmek için her çift birbirine bastırılır.</translation>
    </message>
    <message>
        <source>Gap (mm)</source>
        <translation>Aralık (mm)</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>Sahnede</translation>
    </message>
    <message>
        <source>Its region</source>
        <translation>Bölgesi</translation>
    </message>
    <message>
        <source>Lay it on</source>
        <translation>Üstüne yerleştir</translation>
    </message>
    <message>
        <source>Move apart</source>
        <translation>Ayır</translation>
    </message>
    <message>
        <source>New s&amp;cene…</source>
        <translation>Yeni s&amp;ahne…</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Yeni sahne</translation>
    </message>
    <message>
        <source>No two that may touch are near enough to be pressed together.</source>
        <translation>Dokunabilenlerden hiçbiri birbirine bastırılacak kadar yakın değil.</translation>
    </message>
    <message>
        <source>Not published: see the checks on the right.</source>
        <translation>Yayımlanmadı: sağdaki denetimlere bakın.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this scene.</source>
        <translation>Bu sahnede yanlış bir şey yok.</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organlar</translation>
    </message>
    <message>
        <source>Parts of it may touch each other</source>
        <translation>Parçaları birbirine dokunabilir</translation>
    </message>
    <message>
        <source>Scanned as it lies: gravity leaves it as it is</source>
        <translation>Durduğu gibi tarandı: yerçekimi onu değiştirmez</translation>
    </message>
    <message>
        <source>Instruments rub on it otherwise</source>
        <translation>Aletler ona başka sürtünür</translation>
    </message>
    <message>
        <source>Coulomb's coefficient. Otherwise that of the instrument, as on all else.</source>
        <translation>Coulomb katsayısı. Yoksa, geri kalan her şeyde olduğu gibi, aletinki.</translation>
    </message>
    <message>
        <source>Coulomb's coefficient: some hundredths of wet serosa; 0: they slide.</source>
        <translation>Coulomb katsayısı: ıslak serozanınki yüzde birkaçtır; 0: kayarlar.</translation>
    </message>
    <message>
        <source>Place published organs, stones and scenery, and say which may touch.</source>
        <translation>Yayımlanmış organları, taşları ve sabit çevreyi yerleştirin; hangilerinin dokunabileceğini belirtin.</translation>
    </message>
    <message>
        <source>Each jaw opens</source>
        <translation>Her çene açılır</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Yerçekimi</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Alet</translation>
    </message>
    <message>
        <source>It bears them and slows them down</source>
        <translation>Onları kaldırır ve yavaşlatır</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Yarıçap</translation>
    </message>
    <message>
        <source>Spheres of its hull</source>
        <translation>Kabuğunun küreleri</translation>
    </message>
    <message>
        <source>Stones are in a fluid</source>
        <translation>Taşlar bir sıvının içinde</translation>
    </message>
    <message>
        <source>Task in Turkish</source>
        <translation>Türkçe görev</translation>
    </message>
    <message>
        <source>That of the first organ</source>
        <translation>İlk organınki</translation>
    </message>
    <message>
        <source>Through a trocar at</source>
        <translation>Şuradaki trokardan</translation>
    </message>
    <message>
        <source>Title in Turkish</source>
        <translation>Türkçe başlık</translation>
    </message>
    <message>
        <source>Title, task and surroundings</source>
        <translation>Başlık, görev ve çevre</translation>
    </message>
    <message>
        <source>Without it, as the first organ was published, often none</source>
        <translation>Bu olmadan, ilk organ yayımlandığı gibi, çoğunlukla yok</translation>
    </message>
    <message>
        <source>Without one the device turns it</source>
        <translation>Trokar olmadan aygıt onu döndürür</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Yoğunluk</translation>
    </message>
    <message>
        <source>Length that touches</source>
        <translation>Dokunan uzunluk</translation>
    </message>
    <message>
        <source>slipped off at {force}: press deeper</source>
        <translation>{force} kuvvetinde kaydı: daha derine bastırın</translation>
    </message>
    <message>
        <source>Press each pair</source>
        <translation>Her çifti bastır</translation>
    </message>
    <message>
        <source>Pressing each pair</source>
        <translation>Her çift bastırılıyor</translation>
    </message>
    <message>
        <source>Publish the scene</source>
        <translation>Sahneyi yayımla</translation>
    </message>
    <message>
        <source>Publish the scene…</source>
        <translation>Sahneyi yayımla…</translation>
    </message>
    <message>
        <source>Reading the scene</source>
        <translation>Sahne okunuyor</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Sahneden çıkar</translation>
    </message>
    <message>
        <source>Scenery</source>
        <translation>Sabit çevre</translation>
    </message>
    <message>
        <source>Scenery…</source>
        <translation>Sabit çevre…</translation>
    </message>
    <message>
        <source>Scenes ({names})</source>
        <translation>Sahneler ({names})</translation>
    </message>
    <message>
        <source>Stands at</source>
        <translation>Konumu</translation>
    </message>
    <message>
        <source>Stands at (mm)</source>
        <translation>Konumu (mm)</translation>
    </message>
    <message>
        <source>Stones</source>
        <translation>Taşlar</translation>
    </message>
    <message>
        <source>The scene has changed meanwhile: try again.</source>
        <translation>Sahne bu arada değişti: yeniden deneyin.</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Dönüşü</translation>
    </message>
    <message>
        <source>What may touch</source>
        <translation>Dokunabilenler</translation>
    </message>
    <message>
        <source>With two organs you say here whether they touch.</source>
        <translation>İki organ olunca dokunup dokunmadıklarını burada belirtirsiniz.</translation>
    </message>
    <message>
        <source>onto</source>
        <translation>şunun üstüne</translation>
    </message>
    <message>
        <source>stiff (N/mm³)</source>
        <translation>sertlik (N/mm³)</translation>
    </message>
    <message>
        <source>thick (mm)</source>
        <translation>kalınlık (mm)</translation>
    </message>
    <message>
        <source>{name} was moved {far} mm away from {other}.</source>
        <translation>{name}, {other} parçasından {far} mm uzaklaştırıldı.</translation>
    </message>
    <message>
        <source>{one} and {other}</source>
        <translation>{one} ve {other}</translation>
    </message>
    <message>
        <source>{one} stops {other}</source>
        <translation>{one}, {other} için engeldir</translation>
    </message>
    <message>
        <source>A ball of 10 mm around a point of the organ</source>
        <translation>Organın bir noktası çevresinde 10 mm yarıçaplı bir küre</translation>
    </message>
    <message>
        <source>A careful hand plays</source>
        <translation>Dikkatli bir el oynuyor</translation>
    </message>
    <message>
        <source>A careful hand: {outcome} in {time} s, {errors} errors, peak {peak} N.</source>
        <translation>Dikkatli el: {outcome}, {time} s, {errors} hata, en yüksek {peak} N.</translation>
    </message>
    <message>
        <source>A limit is a warning, an error, or the end of the task. An organ without steps is published as one to feel.</source>
        <translation>Bir sınır uyarıdır, hatadır ya da görevi bitirir. Adımı olmayan bir organ, hissedilecek bir organ olarak yayımlanır.</translation>
    </message>
    <message>
        <source>A muted step stays here, and is not published</source>
        <translation>Susturulan adım burada kalır, yayımlanmaz</translation>
    </message>
    <message>
        <source>A step is a verb, a place and a band of force or depth. It is done once all has been so for as long as you say, and the next one begins.</source>
        <translation>Bir adım; eylem, yer ve kuvvet ya da derinlik aralığıdır. Hepsi istediğiniz süre boyunca sağlanınca tamamlanır ve sonraki başlar.</translation>
    </message>
    <message>
        <source>Add an instrument</source>
        <translation>Alet ekle</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Aletler</translation>
    </message>
    <message>
        <source>Kind of {name}</source>
        <translation>{name} türü</translation>
    </message>
    <message>
        <source>Space at x</source>
        <translation>Boşluk x</translation>
    </message>
    <message>
        <source>Space at y</source>
        <translation>Boşluk y</translation>
    </message>
    <message>
        <source>Space at z</source>
        <translation>Boşluk z</translation>
    </message>
    <message>
        <source>Radius of the space</source>
        <translation>Boşluğun yarıçapı</translation>
    </message>
    <message>
        <source>A space has a radius above 0.</source>
        <translation>Bir boşluğun yarıçapı 0’dan büyüktür.</translation>
    </message>
    <message>
        <source>The scene is being read: try again.</source>
        <translation>Sahne okunuyor: yeniden deneyin.</translation>
    </message>
    <message>
        <source>New task</source>
        <translation>Yeni görev</translation>
    </message>
    <message>
        <source>Remove the task</source>
        <translation>Görevi kaldır</translation>
    </message>
    <message>
        <source>A task is of what is in the scene: add an organ first.</source>
        <translation>Görev sahnede olanlarla ilgilidir: önce bir organ ekleyin.</translation>
    </message>
    <message>
        <source>The scene itself is not right yet: see its checks.</source>
        <translation>Sahnenin kendisi henüz doğru değil: denetimlerine bakın.</translation>
    </message>
    <message>
        <source>The task cannot be played yet: see the checks.</source>
        <translation>Görev henüz oynanamaz: denetimlere bakın.</translation>
    </message>
    <message>
        <source>as in the scene</source>
        <translation>sahnedeki gibi</translation>
    </message>
    <message>
        <source>as in Material</source>
        <translation>Malzemedeki gibi</translation>
    </message>
    <message>
        <source>Trocar to the side</source>
        <translation>Trokarın yana kayması</translation>
    </message>
    <message>
        <source>Tip to handle</source>
        <translation>Uçtan tutamağa</translation>
    </message>
    <message>
        <source>With which instrument</source>
        <translation>Hangi aletle</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bilye</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Prob</translation>
    </message>
    <message>
        <source>Laparoscope</source>
        <translation>Laparoskop</translation>
    </message>
    <message>
        <source>Grasper</source>
        <translation>Kavrayıcı</translation>
    </message>
    <message>
        <source>Syringe</source>
        <translation>Şırınga</translation>
    </message>
    <message>
        <source>Instruments are those of the Test stage too, where Tab gives the mouse to the next one. What each costs of a tick stands in the budget bar.</source>
        <translation>Aletler Deneme aşamasında da vardır; orada Tab fareyi bir sonrakine verir. Her birinin bir tikten ne aldığı bütçe çubuğunda yazar.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Sürtünme</translation>
    </message>
    <message>
        <source>Grip force</source>
        <translation>Kavrama kuvveti</translation>
    </message>
    <message>
        <source>Trocar height</source>
        <translation>Trokar yüksekliği</translation>
    </message>
    <message>
        <source>Add a limit</source>
        <translation>Sınır ekle</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Adım ekle</translation>
    </message>
    <message>
        <source>Careful hand</source>
        <translation>Dikkatli el</translation>
    </message>
    <message>
        <source>Careful hands finish, idle and violent ones do not.</source>
        <translation>Dikkatli eller bitiriyor, duran ve sert eller bitirmiyor.</translation>
    </message>
    <message>
        <source>Careful, idle, violent and clumsy hands, every level</source>
        <translation>Dikkatli, duran, sert ve beceriksiz eller, her düzey</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Açıklık</translation>
    </message>
    <message>
        <source>Click a point</source>
        <translation>Nokta tıkla</translation>
    </message>
    <message>
        <source>Click along the organ; Enter or a double click ends it</source>
        <translation>Organ boyunca tıklayın; Enter ya da çift tıklama bitirir</translation>
    </message>
    <message>
        <source>Click along the organ; Enter or the right button ends the line, Esc leaves</source>
        <translation>Organ boyunca tıklayın; Enter ya da sağ düğme çizgiyi bitirir, Esc çıkar</translation>
    </message>
    <message>
        <source>Click on the organ where the step shall be, Esc to leave</source>
        <translation>Adımın olacağı yere, organın üzerine tıklayın; Esc çıkar</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Temas</translation>
    </message>
    <message>
        <source>Do it once with the mouse: the band is what was felt, 20 % less to 20 % more</source>
        <translation>Fareyle bir kez yapın: aralık, hissedilenin yüzde 20 azından yüzde 20 çoğuna kadardır</translation>
    </message>
    <message>
        <source>Do the step once with the mouse, then stop</source>
        <translation>Adımı fareyle bir kez yapın, sonra durdurun</translation>
    </message>
    <message>
        <source>Drag a step to another place in the order</source>
        <translation>Bir adımı sırada başka bir yere sürükleyin</translation>
    </message>
    <message>
        <source>Draw a line</source>
        <translation>Çizgi çiz</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Çoğalt</translation>
    </message>
    <message>
        <source>Every hand</source>
        <translation>Bütün eller</translation>
    </message>
    <message>
        <source>Find and click</source>
        <translation>Bul ve tıkla</translation>
    </message>
    <message>
        <source>Look at</source>
        <translation>Bak</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Dışarı çıkar</translation>
    </message>
    <message>
        <source>Carry to</source>
        <translation>Götür</translation>
    </message>
    <message>
        <source>Follow a line</source>
        <translation>Çizgiyi izle</translation>
    </message>
    <message>
        <source>Grasp</source>
        <translation>Kavra</translation>
    </message>
    <message>
        <source>Hands play every level</source>
        <translation>Eller her düzeyi oynuyor</translation>
    </message>
    <message>
        <source>Kept for</source>
        <translation>Tutma süresi</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Bırak</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Sınırlar</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Sustur</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Yeni senaryo</translation>
    </message>
    <message>
        <source>Nothing is wrong with the task in 20 attempts of each level.</source>
        <translation>Her düzeyin 20 denemesinde görevde yanlış bir şey yok.</translation>
    </message>
    <message>
        <source>Nothing was pressed, so the band stays as it was.</source>
        <translation>Hiçbir yere bastırılmadı, aralık olduğu gibi kalıyor.</translation>
    </message>
    <message>
        <source>Off the line</source>
        <translation>Çizgi dışı</translation>
    </message>
    <message>
        <source>Press and hold</source>
        <translation>Bastır ve tut</translation>
    </message>
    <message>
        <source>Pull out</source>
        <translation>Dışarı çek</translation>
    </message>
    <message>
        <source>Pulled distance</source>
        <translation>Çekilen uzaklık</translation>
    </message>
    <message>
        <source>Push in</source>
        <translation>İçeri it</translation>
    </message>
    <message>
        <source>Rate of force</source>
        <translation>Kuvvet değişim hızı</translation>
    </message>
    <message>
        <source>Record from my hand</source>
        <translation>Elimden kaydet</translation>
    </message>
    <message>
        <source>Say what a trainee does, step by step; it is judged in every tick.</source>
        <translation>Eğitim alanın ne yapacağını adım adım söyleyin; her adımlamada değerlendirilir.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Tohum</translation>
    </message>
    <message>
        <source>Self-play</source>
        <translation>Kendi kendine oynama</translation>
    </message>
    <message>
        <source>Share of the line</source>
        <translation>Çizginin payı</translation>
    </message>
    <message>
        <source>Simulated hands try the task out. They test its numbers, not what it teaches.</source>
        <translation>Benzetilmiş eller görevi dener. Sayılarını sınarlar, ne öğrettiğini değil.</translation>
    </message>
    <message>
        <source>Stop: take the band</source>
        <translation>Dur: aralığı al</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Gerinim</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Düşürülmesi</translation>
    </message>
    <message>
        <source>Tip out of view</source>
        <translation>Uç görüş dışında</translation>
    </message>
    <message>
        <source>Force on an object</source>
        <translation>Nesne üzerindeki kuvvet</translation>
    </message>
    <message>
        <source>Pressure of the jaws</source>
        <translation>Çenelerin basıncı</translation>
    </message>
    <message>
        <source>Torn tissue</source>
        <translation>Yırtılan doku</translation>
    </message>
    <message>
        <source>object</source>
        <translation>nesne</translation>
    </message>
    <message>
        <source>space</source>
        <translation>uzay</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Metinler</translation>
    </message>
    <message>
        <source>The chosen step</source>
        <translation>Seçilen adım</translation>
    </message>
    <message>
        <source>The organ is not compiled yet.</source>
        <translation>Organ henüz derlenmedi.</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Süre sınırı</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Dokun</translation>
    </message>
    <message>
        <source>Unmute</source>
        <translation>Sesi aç</translation>
    </message>
    <message>
        <source>What is to be done</source>
        <translation>Ne yapılacak</translation>
    </message>
    <message>
        <source>What it comes to</source>
        <translation>Sonucu</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Nerede</translation>
    </message>
    <message>
        <source>Without a task the organ is published as one to feel.</source>
        <translation>Görev olmadan organ, hissedilecek bir organ olarak yayımlanır.</translation>
    </message>
    <message>
        <source>a warning</source>
        <translation>uyarı</translation>
    </message>
    <message>
        <source>an error</source>
        <translation>hata</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>küre</translation>
    </message>
    <message>
        <source>done</source>
        <translation>tamam</translation>
    </message>
    <message>
        <source>ends the task</source>
        <translation>görevi bitirir</translation>
    </message>
    <message>
        <source>least</source>
        <translation>en az</translation>
    </message>
    <message>
        <source>line</source>
        <translation>çizgi</translation>
    </message>
    <message>
        <source>most</source>
        <translation>en çok</translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>tamam değil</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>tohum</translation>
    </message>
    <message>
        <source>wrong above</source>
        <translation>üstü yanlış</translation>
    </message>
    <message>
        <source>wrong below</source>
        <translation>altı yanlış</translation>
    </message>
    <message>
        <source>{key} is missing</source>
        <translation>{key} eksik</translation>
    </message>
    <message>
        <source>Damped by the link</source>
        <translation>Bağlantının sönümlemesi</translation>
    </message>
    <message>
        <source>Stiffness not felt</source>
        <translation>Hissedilmeyen sertlik</translation>
    </message>
    <message>
        <source>Late exchanges</source>
        <translation>Geciken alışverişler</translation>
    </message>
    <message>
        <source>foot (ft)</source>
        <translation>ayak (ft)</translation>
    </message>
    <message>
        <source>{length} long</source>
        <translation>{length} uzunlukta</translation>
    </message>
    <message>
        <source>Series of the folder</source>
        <translation>Klasördeki seriler</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Seri</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>adsız</translation>
    </message>
    <message>
        <source>{title}: {slices} slices of {columns} × {rows}</source>
        <translation>{title}: {columns} × {rows} boyutunda {slices} kesit</translation>
    </message>
    <message>
        <source>{size} mm, {triangles} △</source>
        <translation>{size} mm, {triangles} △</translation>
    </message>
    <message>
        <source>{count} parts: {first}, …</source>
        <translation>{count} parça ({first}, …)</translation>
    </message>
    <message>
        <source>Taken away from the others</source>
        <translation>Ötekilerden çıkarılıyor</translation>
    </message>
    <message>
        <source>Take its inside away from the others</source>
        <translation>İçini ötekilerden çıkar</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Yeniden göster</translation>
    </message>
    <message>
        <source>Hide it in the view</source>
        <translation>Görünümde gizle</translation>
    </message>
    <message>
        <source>Choose this alone</source>
        <translation>Yalnızca bunu seç</translation>
    </message>
    <message>
        <source>Take nothing away</source>
        <translation>Çıkarma</translation>
    </message>
    <message>
        <source>open</source>
        <translation>açık</translation>
    </message>
    <message>
        <source>inside {part}</source>
        <translation>içinde: {part}</translation>
    </message>
    <message>
        <source>crosses {parts}</source>
        <translation>kesişir: {parts}</translation>
    </message>
    <message>
        <source>{count} of its triangles cross others of its own</source>
        <translation>{count} üçgeni kendi üçgenlerini kesiyor</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Yan yana</translation>
    </message>
    <message>
        <source>As solids, united</source>
        <translation>Katı olarak, birleşik</translation>
    </message>
    <message>
        <source>where they meet</source>
        <translation>buluştukları yerde</translation>
    </message>
    <message>
        <source>Vertices of different parts that are closer become one</source>
        <translation>Farklı parçaların bundan yakın köşeleri bir olur</translation>
    </message>
    <message>
        <source>Keep each part as a region, for a tissue of its own</source>
        <translation>Her parçayı kendi dokusu olacak bir bölge olarak tut</translation>
    </message>
    <message>
        <source>Weld across</source>
        <translation>Arası kaynak</translation>
    </message>
    <message>
        <source>Put together</source>
        <translation>Bir araya getirme</translation>
    </message>
    <message>
        <source>Outer ones</source>
        <translation>Dıştakiler</translation>
    </message>
    <message>
        <source>The parts that lie inside no other</source>
        <translation>Başka birinin içinde olmayan parçalar</translation>
    </message>
    <message>
        <source>Looking at its parts</source>
        <translation>Parçalarına bakılıyor</translation>
    </message>
    <message>
        <source>Measured while the organ is felt.</source>
        <translation>Organ hissedilirken ölçülür.</translation>
    </message>
    <message>
        <source>Measured once the organ is compiled.</source>
        <translation>Organ derlenince ölçülür.</translation>
    </message>
    <message>
        <source>The organ is being pressed to measure it…</source>
        <translation>Ölçmek için organa bastırılıyor…</translation>
    </message>
    <message>
        <source>An alarm ended the press: see the Test stage.</source>
        <translation>Basışı bir alarm bitirdi: Dene aşamasına bakın.</translation>
    </message>
    <message>
        <source>Whole tick</source>
        <translation>Adımın tümü</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parça</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Ortanca</translation>
    </message>
    <message>
        <source>A tick may take {time}.</source>
        <translation>Bir adım en çok {time} sürebilir.</translation>
    </message>
    <message>
        <source>{name}: {median}, p99 {p99}</source>
        <translation>{name}: {median}, p99 {p99}</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Alet</translation>
    </message>
    <message>
        <source>{tool} on {body}</source>
        <translation>{tool} – {body}</translation>
    </message>
    <message>
        <source>&amp;About Palpate</source>
        <translation>Palpate &amp;hakkında</translation>
    </message>
    <message>
        <source>&amp;Above</source>
        <translation>&amp;Üstten</translation>
    </message>
    <message>
        <source>&amp;Back to rest</source>
        <translation>&amp;Dinlenmeye dön</translation>
    </message>
    <message>
        <source>&amp;Behind</source>
        <translation>&amp;Arkadan</translation>
    </message>
    <message>
        <source>As many tetrahedra are made as are asked for, to a tenth; more are nearer to the tissue and take longer. A nodal share of 0 lets volumes lock, which makes the organ too stiff; 1 lets tetrahedra turn inside out.</source>
        <translation>Onda bir farkla istenen sayıda dörtyüzlü oluşturulur; sayı arttıkça model dokuya yaklaşır, hesap uzar. Düğüm payı 0 olursa hacimler kilitlenir, organ fazla sert olur; 1 olursa dörtyüzlüler tersyüz olabilir.</translation>
    </message>
    <message>
        <source>All of the surface</source>
        <translation>Yüzeyin tamamı</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Dolgu</translation>
    </message>
    <message>
        <source>Haptic de&amp;vice…</source>
        <translation>Dokunsal ay&amp;gıt…</translation>
    </message>
    <message>
        <source>&amp;Check the organ</source>
        <translation>Organı &amp;denetle</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Renkler</translation>
    </message>
    <message>
        <source>&amp;Copy the material</source>
        <translation>Malzemeyi &amp;kopyala</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Koyu</translation>
    </message>
    <message>
        <source>&amp;Decimate</source>
        <translation>&amp;Sadeleştir</translation>
    </message>
    <message>
        <source>&amp;Distance to the source</source>
        <translation>Kaynağa &amp;uzaklık</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Düzen</translation>
    </message>
    <message>
        <source>&amp;Feel it / pause</source>
        <translation>&amp;Dokun / duraklat</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Dosya</translation>
    </message>
    <message>
        <source>&amp;Find an action…</source>
        <translation>&amp;Bir işlem bul…</translation>
    </message>
    <message>
        <source>&amp;Forget them</source>
        <translation>&amp;Bunları unut</translation>
    </message>
    <message>
        <source>&amp;Free all</source>
        <translation>&amp;Hepsini serbest bırak</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Ö&amp;nden</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Tam ekran</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Yardım</translation>
    </message>
    <message>
        <source>&amp;Help on this stage</source>
        <translation>Bu aşama için &amp;yardım</translation>
    </message>
    <message>
        <source>&amp;Import a mesh…</source>
        <translation>Ağ &amp;içe aktar…</translation>
    </message>
    <message>
        <source>&amp;Import again</source>
        <translation>Yeniden &amp;içe aktar</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Klavye ve fare</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Dil</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Soldan</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Açık</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Bakış yönü</translation>
    </message>
    <message>
        <source>&amp;Mass–spring model</source>
        <translation>&amp;Kütle–yay modeli</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Ağ</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Yeni</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Aç…</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneller</translation>
    </message>
    <message>
        <source>&amp;Paste the material</source>
        <translation>Malzemeyi &amp;yapıştır</translation>
    </message>
    <message>
        <source>&amp;Publish</source>
        <translation>Ya&amp;yımla</translation>
    </message>
    <message>
        <source>&amp;Publish…</source>
        <translation>&amp;Yayımla…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Çık</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Yinele</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Düzeni &amp;sıfırla</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>S&amp;ağdan</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Kaydet</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Benzetim</translation>
    </message>
    <message>
        <source>&amp;Stage</source>
        <translation>&amp;Aşama</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Tissue</source>
        <translation>&amp;Doku</translation>
    </message>
    <message>
        <source>&amp;Turn outwards</source>
        <translation>&amp;Dışa çevir</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Geri al</translation>
    </message>
    <message>
        <source>&amp;Use the imported surface</source>
        <translation>İçe aktarılan yüzeyi k&amp;ullan</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Görünüm</translation>
    </message>
    <message>
        <source>&amp;Force as an arrow</source>
        <translation>Kuvveti &amp;ok olarak göster</translation>
    </message>
    <message>
        <source>Force {number}</source>
        <translation>Kuvvet {number}</translation>
    </message>
    <message>
        <source>Jaws</source>
        <translation>Çeneler</translation>
    </message>
    <message>
        <source>Jaws {number}</source>
        <translation>Çeneler {number}</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Gerilme</translation>
    </message>
    <message>
        <source>Stretch {number}</source>
        <translation>Gerilme {number}</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Dönüş</translation>
    </message>
    <message>
        <source>Turning {number}</source>
        <translation>Dönüş {number}</translation>
    </message>
    <message>
        <source>held by tissue</source>
        <translation>dokuca tutuluyor</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>Tel &amp;kafes</translation>
    </message>
    <message>
        <source>A file rarely says how long its unit is. The editor guesses by the size of the organ and says why; correct it where it is wrong, and everything follows.</source>
        <translation>Bir dosya birimini nadiren belirtir. Düzenleyici, organın boyutundan tahmin eder ve nedenini söyler; yanlışsa düzeltin, gerisi kendiliğinden uyar.</translation>
    </message>
    <message>
        <source>A mesh from a scan or a modeller (OBJ, STL, PLY, glTF, FBX …), or an .organ file.</source>
        <translation>Bir taramadan ya da modelleyiciden bir ağ (OBJ, STL, PLY, glTF, FBX …) veya bir .organ dosyası.</translation>
    </message>
    <message>
        <source>A published file holds the finished model and everything needed to feel it; it also holds your document, so it can be opened here again.</source>
        <translation>Yayımlanmış dosya, bitmiş modeli ve ona dokunmak için gereken her şeyi içerir; belgenizi de içerdiğinden burada yeniden açılabilir.</translation>
    </message>
    <message>
        <source>A scripted press gives numbers that can be compared from one day to the next.</source>
        <translation>Betikli bası, bir günden ötekine karşılaştırılabilen sayılar verir.</translation>
    </message>
    <message>
        <source>A wall can have its constants from the tissue: choose so under Constants, and read what the model makes of the wall. A shell of prisms bends as well.</source>
        <translation>Bir duvarın sabitleri dokudan gelebilir: Sabitler altında öyle seçin ve modelin duvardan ne çıkardığını okuyun. Prizmalardan kabuk eğilir de.</translation>
    </message>
    <message>
        <source>About {share} of a millisecond for every tick.</source>
        <translation>Her adım için bir milisaniyenin yaklaşık {share} kadarı.</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Sonra</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tümü</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Sorun yok</translation>
    </message>
    <message>
        <source>This organ has no problems.</source>
        <translation>Bu organda sorun yok.</translation>
    </message>
    <message>
        <source>All triangles face outwards.</source>
        <translation>Tüm üçgenler dışa bakıyor.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Açıldığı hâli</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>&amp;Masaüstü gibi</translation>
    </message>
    <message>
        <source>As the &amp;stage needs</source>
        <translation>&amp;Aşamaya göre</translation>
    </message>
    <message>
        <source>Ask me later</source>
        <translation>Sonra sor</translation>
    </message>
    <message>
        <source>Axis up</source>
        <translation>Yukarı eksen</translation>
    </message>
    <message>
        <source>Be&amp;low</source>
        <translation>&amp;Alttan</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Önce</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Önce ve sonra</translation>
    </message>
    <message>
        <source>Import a surface, and confirm its unit and its axis.</source>
        <translation>Bir yüzeyi içe aktarın, birimini ve eksenini onaylayın.</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>Fırça yarıçapı</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Elle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Vazgeç</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Denetimler</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Seç…</translation>
    </message>
    <message>
        <source>Chosen by hand to feel like an organ, or given by what the tissue is made of.</source>
        <translation>Organ gibi duyulsun diye elle seçilmiş ya da dokunun yapısından gelen sabitler.</translation>
    </message>
    <message>
        <source>Clear the force plo&amp;t</source>
        <translation>Kuvvet &amp;çizimini temizle</translation>
    </message>
    <message>
        <source>Clear the plot</source>
        <translation>Çizimi temizle</translation>
    </message>
    <message>
        <source>Click on an end to look from there</source>
        <translation>Oradan bakmak için bir uca tıklayın</translation>
    </message>
    <message>
        <source>Click on the organ where the tip shall press, Esc to leave</source>
        <translation>Ucun basacağı yere organın üzerinde tıklayın, çıkmak için Esc</translation>
    </message>
    <message>
        <source>Click or drag to select, Ctrl to add, Alt to remove, L takes what is linked, Ctrl+A all, Ctrl+I the others, Esc to leave</source>
        <translation>Seçmek için tıklayın ya da sürükleyin; Ctrl ekler, Alt çıkarır, L bağlı olanları alır, Ctrl+A tümü, Ctrl+I ötekiler, Esc çıkar</translation>
    </message>
    <message>
        <source>Command palette</source>
        <translation>Komut paleti</translation>
    </message>
    <message>
        <source>Compiling the organ…</source>
        <translation>Organ derleniyor…</translation>
    </message>
    <message>
        <source>Computing one tick of the simulation, median of the last second, and its share of the millisecond it may take.</source>
        <translation>Benzetimin bir adımının hesabı, son saniyenin ortancası ve kullanabileceği milisaniyedeki payı.</translation>
    </message>
    <message>
        <source>Connected only</source>
        <translation>Yalnız bağlı olanlar</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Maliyet</translation>
    </message>
    <message>
        <source>Publish although it is late here, for a faster machine</source>
        <translation>Burada geç kalsa da daha hızlı bir bilgisayar için yayımla</translation>
    </message>
    <message>
        <source>Cost of a tick</source>
        <translation>Bir adımın maliyeti</translation>
    </message>
    <message>
        <source>Cost of a tick in touch</source>
        <translation>Temas sırasında bir adımın maliyeti</translation>
    </message>
    <message>
        <source>Crossing triangles</source>
        <translation>Kesişen üçgenler</translation>
    </message>
    <message>
        <source>Decimate</source>
        <translation>Sadeleştir</translation>
    </message>
    <message>
        <source>Decimating</source>
        <translation>Sadeleştiriliyor</translation>
    </message>
    <message>
        <source>Decimating always starts from the imported surface, so you can try several counts. What you have painted is carried over; its borders, ridges and thin parts are kept as far as there are vertices for them.</source>
        <translation>Sadeleştirme her zaman içe aktarılan yüzeyden başlar, böylece birkaç sayı deneyebilirsiniz. Boyadıklarınız aktarılır; sınırları, sırtlar ve ince kısımlar köşe sayısı yettiği ölçüde korunur.</translation>
    </message>
    <message>
        <source>Decimating to {count} vertices</source>
        <translation>{count} köşeye sadeleştiriliyor</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Derinlik</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Kapat</translation>
    </message>
    <message>
        <source>Distance to the source [mm]</source>
        <translation>Kaynağa uzaklık [mm]</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Kaydetme</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Bitti</translation>
    </message>
    <message>
        <source>Doubled points are welded, doubled and empty triangles removed, and triangles turned so that all face outwards. What was done stands in the panel.</source>
        <translation>Yinelenen noktalar kaynaştırılır, yinelenen ve boş üçgenler silinir, üçgenler hepsi dışa bakacak biçimde çevrilir. Yapılanlar panelde yazar.</translation>
    </message>
    <message>
        <source>Drag to fix, Ctrl to free, [ ] or Ctrl+wheel for the size, Esc to leave</source>
        <translation>Sabitlemek için sürükleyin, Ctrl serbest bırakır, boyut için [ ] ya da Ctrl+tekerlek, Esc çıkar</translation>
    </message>
    <message>
        <source>Drag to paint, Ctrl to erase, Shift to smooth, [ ] or Ctrl+wheel for the size, Esc to leave</source>
        <translation>Boyamak için sürükleyin, Ctrl siler, Shift yumuşatır, boyut için [ ] ya da Ctrl+tekerlek, Esc çıkar</translation>
    </message>
    <message>
        <source>Drag to turn, Shift+drag to move, wheel to zoom</source>
        <translation>Döndürmek için sürükleyin, taşımak için Shift+sürükleyin, yakınlaştırmak için tekerlek</translation>
    </message>
    <message>
        <source>Drop a mesh file on the window, or choose one. Files with several parts, such as a whole heart, can be used in part: tick what you need and import again.</source>
        <translation>Pencereye bir ağ dosyası bırakın ya da seçin. Bütün bir kalp gibi birkaç parçalı dosyalar kısmen kullanılabilir: gerekenleri işaretleyip yeniden içe aktarın.</translation>
    </message>
    <message>
        <source>Drop an organ here</source>
        <translation>Buraya bir organ bırakın</translation>
    </message>
    <message>
        <source>E&amp;xport the forces…</source>
        <translation>Kuvvetleri &amp;dışa aktar…</translation>
    </message>
    <message>
        <source>Edges shared by more than two</source>
        <translation>İkiden çok üçgenli kenar</translation>
    </message>
    <message>
        <source>Error of stretching</source>
        <translation>Uzama hatası</translation>
    </message>
    <message>
        <source>Even out</source>
        <translation>Eşitle</translation>
    </message>
    <message>
        <source>Every number has its unit beside it. Type a value, or use the arrow keys. Mass, substeps and the stability margin follow at once.</source>
        <translation>Her sayının yanında birimi vardır. Bir değer yazın ya da ok tuşlarını kullanın. Kütle, alt adımlar ve kararlılık payı hemen güncellenir.</translation>
    </message>
    <message>
        <source>Every tick of the run and, beside it, the organ: to replay and to compare</source>
        <translation>Çalışmanın her adımı ve yanında organ: yeniden oynatmak ve karşılaştırmak için</translation>
    </message>
    <message>
        <source>Every triangle can take a stretch-bend of {low} to {high} N.</source>
        <translation>Her üçgen {low} ile {high} N arası gerilme–eğilme kaldırabilir.</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Beklenen</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>CSV olarak dışa aktar…</translation>
    </message>
    <message>
        <source>Export forces</source>
        <translation>Kuvvetleri dışa aktar</translation>
    </message>
    <message>
        <source>Fade towards the rim</source>
        <translation>Kenara doğru azalır</translation>
    </message>
    <message>
        <source>Feel the organ in the loop a device will run, 1000 times a second.</source>
        <translation>Organa, bir cihazın saniyede 1000 kez çalıştıracağı döngüde dokunun.</translation>
    </message>
    <message>
        <source>Fewer vertices tick faster. The shape shown is what will be felt.</source>
        <translation>Daha az köşe daha hızlı çalışır. Gösterilen biçim, hissedilecek olandır.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Dosya</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Sabitle</translation>
    </message>
    <message>
        <source>Fix it</source>
        <translation>Düzelt</translation>
    </message>
    <message>
        <source>Fix the &amp;lowest part</source>
        <translation>En &amp;alt kısmı sabitle</translation>
    </message>
    <message>
        <source>Fix the lowest</source>
        <translation>En altı sabitle</translation>
    </message>
    <message>
        <source>Fix the selected vertices</source>
        <translation>Seçili köşeleri sabitle</translation>
    </message>
    <message>
        <source>Fix what is attached to the body, and paint places that are harder: choose a brush at the left, and drag over the organ.</source>
        <translation>Vücuda bağlı olanı sabitleyin ve daha sert yerleri boyayın: soldan bir fırça seçip organın üzerinde sürükleyin.</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Sabit</translation>
    </message>
    <message>
        <source>Fixed vertices</source>
        <translation>Sabit köşeler</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kuvvet</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kuvvet [N]</translation>
    </message>
    <message>
        <source>Forces exported to {file}</source>
        <translation>Kuvvetler {file} dosyasına aktarıldı</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Unut</translation>
    </message>
    <message>
        <source>Forget this name; nothing else changes</source>
        <translation>Bu adı unutur; başka hiçbir şey değişmez</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Bulunan</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Serbest</translation>
    </message>
    <message>
        <source>Free all</source>
        <translation>Hepsini bırak</translation>
    </message>
    <message>
        <source>Free the selected vertices</source>
        <translation>Seçili köşeleri serbest bırak</translation>
    </message>
    <message>
        <source>Front side only</source>
        <translation>Yalnız ön yüz</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Safra kesesi</translation>
    </message>
    <message>
        <source>Give every vertex the organ's own stiffness</source>
        <translation>Her köşeye organın kendi katılığını ver</translation>
    </message>
    <message>
        <source>Give the selected vertices this stiffness, times the organ's own</source>
        <translation>Seçili köşelere, organınkinin şu katı katılık ver</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Sürdür</translation>
    </message>
    <message>
        <source>Guessed: {reason}</source>
        <translation>Tahmin: {reason}</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>El</translation>
    </message>
    <message>
        <source>Hand {count}</source>
        <translation>El {count}</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Kulp sayısı</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Yardım</translation>
    </message>
    <message>
        <source>Here is what was not saved. Save it to keep it.</source>
        <translation>Kaydedilmemiş olan burada. Saklamak için kaydedin.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geçmiş</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Bekleme</translation>
    </message>
    <message>
        <source>Hold the selected vertices at rest</source>
        <translation>Seçili köşeleri yerinde tut</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Delikler</translation>
    </message>
    <message>
        <source>Holes are never closed without being asked for: an open surface can be a hollow organ or a sheet, and then needs the thickness of its wall.</source>
        <translation>Delikler siz istemeden kapatılmaz: açık bir yüzey içi boş bir organ ya da bir zar olabilir; o zaman duvar kalınlığı gerekir.</translation>
    </message>
    <message>
        <source>Hollow kidney</source>
        <translation>İçi boş böbrek</translation>
    </message>
    <message>
        <source>How far the tip goes below the surface</source>
        <translation>Ucun yüzeyin ne kadar altına ineceği</translation>
    </message>
    <message>
        <source>How late a tick starts, median of the last second, as a share of the millisecond.</source>
        <translation>Bir adımın ne kadar geç başladığı, son saniyenin ortancası, milisaniyenin payı olarak.</translation>
    </message>
    <message>
        <source>How much of the way to that stiffness one stroke goes</source>
        <translation>Bir fırça darbesinin o katılığa ne kadar yaklaştıracağı</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>İçe aktar</translation>
    </message>
    <message>
        <source>Import a mesh</source>
        <translation>Ağ içe aktar</translation>
    </message>
    <message>
        <source>Import a mesh…</source>
        <translation>Ağ içe aktar…</translation>
    </message>
    <message>
        <source>Import these parts</source>
        <translation>Bu parçaları içe aktar</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>İçe aktarılan</translation>
    </message>
    <message>
        <source>Importing again keeps your constants but forgets what was painted.</source>
        <translation>Yeniden içe aktarmak sabitlerinizi korur ama boyananları unutur.</translation>
    </message>
    <message>
        <source>Importing {file}</source>
        <translation>{file} içe aktarılıyor</translation>
    </message>
    <message>
        <source>Invert the selection</source>
        <translation>Seçimi tersine çevir</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Sakla</translation>
    </message>
    <message>
        <source>Keep the &amp;largest piece</source>
        <translation>En &amp;büyük parçayı tut</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>En büyük parçayı tut</translation>
    </message>
    <message>
        <source>Keep the selection under this name</source>
        <translation>Seçimi bu adla saklar</translation>
    </message>
    <message>
        <source>Kept in {record}, with the organ beside it in {scene}.</source>
        <translation>{record} içinde saklandı, organ yanında {scene} dosyasında.</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Klavye ve fare</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Böbrek</translation>
    </message>
    <message>
        <source>Kidney stone</source>
        <translation>Böbrek taşı</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Daha büyük fırça</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>En büyük uzaklık</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>Son çalışma</translation>
    </message>
    <message>
        <source>Lateness</source>
        <translation>Gecikme</translation>
    </message>
    <message>
        <source>Leave alone what faces away from you</source>
        <translation>Size dönük olmayana dokunma</translation>
    </message>
    <message>
        <source>Left drag beside the organ, or with Orbit</source>
        <translation>Organın yanında ya da Yörünge ile sol sürükleme</translation>
    </message>
    <message>
        <source>Lengths are shown in millimetres</source>
        <translation>Uzunluklar milimetre olarak gösterilir</translation>
    </message>
    <message>
        <source>Let every vertex move</source>
        <translation>Her köşeyi serbest bırak</translation>
    </message>
    <message>
        <source>Let the selected vertices move</source>
        <translation>Seçili köşeleri serbest bırak</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Bağlantılar</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Karaciğer</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Günlük</translation>
    </message>
    <message>
        <source>Longest stable step</source>
        <translation>En uzun kararlı adım</translation>
    </message>
    <message>
        <source>M&amp;aterial</source>
        <translation>&amp;Malzeme</translation>
    </message>
    <message>
        <source>M&amp;olecular model</source>
        <translation>M&amp;oleküler model</translation>
    </message>
    <message>
        <source>Mass–spring</source>
        <translation>Kütle–yay</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Malzeme</translation>
    </message>
    <message>
        <source>Mean distance to the source</source>
        <translation>Kaynağa ortalama uzaklık</translation>
    </message>
    <message>
        <source>Mean speed of the press and the pull</source>
        <translation>Bası ve çekmenin ortalama hızı</translation>
    </message>
    <message>
        <source>Meaning of the file</source>
        <translation>Dosyanın anlamı</translation>
    </message>
    <message>
        <source>Repaired when it was read</source>
        <translation>Okunurken onarılanlar</translation>
    </message>
    <message>
        <source>Meshes ({names})</source>
        <translation>Ağlar ({names})</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Kaçan</translation>
    </message>
    <message>
        <source>Missed ticks</source>
        <translation>Kaçan adımlar</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Molecular</source>
        <translation>Moleküler</translation>
    </message>
    <message>
        <source>Name of the organ</source>
        <translation>Organın adı</translation>
    </message>
    <message>
        <source>Never reach through a wall or a gap</source>
        <translation>Duvarın ya da boşluğun ötesine geçme</translation>
    </message>
    <message>
        <source>Next: {stage}</source>
        <translation>Sonraki: {stage}</translation>
    </message>
    <message>
        <source>No edge has more than two triangles.</source>
        <translation>Hiçbir kenarda ikiden çok üçgen yok.</translation>
    </message>
    <message>
        <source>No file yet: choose one, or drop it anywhere on this window.</source>
        <translation>Henüz dosya yok: bir tane seçin ya da bu pencerede herhangi bir yere bırakın.</translation>
    </message>
    <message>
        <source>No organ yet</source>
        <translation>Henüz organ yok</translation>
    </message>
    <message>
        <source>No tissue yet</source>
        <translation>Henüz doku yok</translation>
    </message>
    <message>
        <source>No vertices are selected: click or drag on the organ.</source>
        <translation>Seçili köşe yok: organın üzerinde tıklayın ya da sürükleyin.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Hiçbiri</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>Henüz denetlenmedi</translation>
    </message>
    <message>
        <source>Not published: {problems}. See the checks on the right.</source>
        <translation>Yayımlanmadı: {problems}. Sağdaki denetimlere bakın.</translation>
    </message>
    <message>
        <source>Not published: {problems}.</source>
        <translation>Yayımlanmadı: {problems}.</translation>
    </message>
    <message>
        <source>Not validated, not a medical device.</source>
        <translation>Doğrulanmamıştır, tıbbi cihaz değildir.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Hiçbir şey</translation>
    </message>
    <message>
        <source>Nothing felt yet</source>
        <translation>Henüz bir şey hissedilmedi</translation>
    </message>
    <message>
        <source>Nothing is lost: continue where you were?</source>
        <translation>Hiçbir şey kaybolmadı: kaldığınız yerden sürdürülsün mü?</translation>
    </message>
    <message>
        <source>Nothing needed repair</source>
        <translation>Onarılacak bir şey yoktu</translation>
    </message>
    <message>
        <source>Nothing prevents publishing.</source>
        <translation>Yayımlamanın önünde engel yok.</translation>
    </message>
    <message>
        <source>Of the wall's stiffness</source>
        <translation>Duvar katılığına oranı</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Aç</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Son açılanlar</translation>
    </message>
    <message>
        <source>Opening {file}</source>
        <translation>{file} açılıyor</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Aç…</translation>
    </message>
    <message>
        <source>Or begin with one of these</source>
        <translation>Ya da bunlardan biriyle başlayın</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Yörünge</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Organ documents (*.organ)</source>
        <translation>Organ belgeleri (*.organ)</translation>
    </message>
    <message>
        <source>Organs and meshes ({names})</source>
        <translation>Organlar ve ağlar ({names})</translation>
    </message>
    <message>
        <source>P&amp;lay the published file</source>
        <translation>Yayımlananı &amp;oynat</translation>
    </message>
    <message>
        <source>Palpate the spleen</source>
        <translation>Dalağı elle muayene edin</translation>
    </message>
    <message>
        <source>Parts to use</source>
        <translation>Kullanılacak parçalar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Duraklat</translation>
    </message>
    <message>
        <source>Paused: Space goes on.</source>
        <translation>Duraklatıldı: Boşluk tuşu sürdürür.</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Tepe kuvveti</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Seç</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Resimler (*.png)</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Parça sayısı</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Yer</translation>
    </message>
    <message>
        <source>Play the published file</source>
        <translation>Yayımlanan dosyayı oynat</translation>
    </message>
    <message>
        <source>Press from above, over the middle of the organ</source>
        <translation>Organın ortasının üstünden, yukarıdan bas</translation>
    </message>
    <message>
        <source>Press the lower edge gently, then say where the tissue is harder.</source>
        <translation>Alt kenara hafifçe bastırın, sonra dokunun nerede daha sert olduğunu söyleyin.</translation>
    </message>
    <message>
        <source>Press the organ: the force appears here</source>
        <translation>Organa basın: kuvvet burada görünür</translation>
    </message>
    <message>
        <source>Press {count}</source>
        <translation>Bası {count}</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Sorunlar</translation>
    </message>
    <message>
        <source>Problems and log</source>
        <translation>Sorunlar ve günlük</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Yayımla</translation>
    </message>
    <message>
        <source>Publish first: the player plays the published file.</source>
        <translation>Önce yayımlayın: oynatıcı yayımlanan dosyayı oynatır.</translation>
    </message>
    <message>
        <source>Published as {file}.</source>
        <translation>{file} olarak yayımlandı.</translation>
    </message>
    <message>
        <source>Published scenarios (*.palpate)</source>
        <translation>Yayımlanmış senaryolar (*.palpate)</translation>
    </message>
    <message>
        <source>Published values</source>
        <translation>Yayımlanmış değerler</translation>
    </message>
    <message>
        <source>Publishing {file}</source>
        <translation>{file} yayımlanıyor</translation>
    </message>
    <message>
        <source>Publish…</source>
        <translation>Yayımla…</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Çekme</translation>
    </message>
    <message>
        <source>Pull force</source>
        <translation>Çekme kuvveti</translation>
    </message>
    <message>
        <source>Reading {file}</source>
        <translation>{file} okunuyor</translation>
    </message>
    <message>
        <source>Record (*.prec)</source>
        <translation>Kayıt (*.prec)</translation>
    </message>
    <message>
        <source>Errors of any stage, in red, prevent publishing. Each says what it got and what was expected.</source>
        <translation>Herhangi bir aşamanın kırmızı denetimi engeldir. Her biri bulunanı ve bekleneni söyler.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bölge</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Onar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Sıfırla</translation>
    </message>
    <message>
        <source>Right or middle drag while a brush is on</source>
        <translation>Fırça etkinken sağ ya da orta sürükleme</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Çalıştır</translation>
    </message>
    <message>
        <source>Running: Space pauses, R restarts.</source>
        <translation>Çalışıyor: Boşluk tuşu duraklatır, R baştan başlatır.</translation>
    </message>
    <message>
        <source>S&amp;hell of prisms</source>
        <translation>Prizmalardan ka&amp;buk</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Kaydet</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>&amp;Farklı kaydet…</translation>
    </message>
    <message>
        <source>Save a &amp;picture…</source>
        <translation>&amp;Resim kaydet…</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Resim kaydet</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Farklı kaydet</translation>
    </message>
    <message>
        <source>Save record</source>
        <translation>Kaydı sakla</translation>
    </message>
    <message>
        <source>Save record…</source>
        <translation>Kaydı sakla…</translation>
    </message>
    <message>
        <source>Save the r&amp;ecord…</source>
        <translation>Kaydı &amp;sakla…</translation>
    </message>
    <message>
        <source>Save them before going on?</source>
        <translation>Sürdürmeden önce kaydedilsin mi?</translation>
    </message>
    <message>
        <source>Saved as {file}.</source>
        <translation>{file} olarak kaydedildi.</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Senaryo</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Sahne</translation>
    </message>
    <message>
        <source>Scripted &amp;press</source>
        <translation>Betikli &amp;bası</translation>
    </message>
    <message>
        <source>Scripted press</source>
        <translation>Betikli bası</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seç</translation>
    </message>
    <message>
        <source>Select a vertex first: then L takes all that is linked.</source>
        <translation>Önce bir köşe seçin: sonra L bağlı olanların tümünü alır.</translation>
    </message>
    <message>
        <source>Select all vertices</source>
        <translation>Tüm köşeleri seç</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Seçimi bırak</translation>
    </message>
    <message>
        <source>Select what is linked</source>
        <translation>Bağlı olanları seç</translation>
    </message>
    <message>
        <source>Set stiffness</source>
        <translation>Katılık ver</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Kabuk</translation>
    </message>
    <message>
        <source>Shell of prisms</source>
        <translation>Prizmalardan kabuk</translation>
    </message>
    <message>
        <source>Linear solid</source>
        <translation>Doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>Corotated solid</source>
        <translation>Eşdöner dolu cisim</translation>
    </message>
    <message>
        <source>Neo-Hookean solid</source>
        <translation>Neo-Hooke dolu cisim</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Dolu cisim</translation>
    </message>
    <message>
        <source>Shift / Ctrl with a brush</source>
        <translation>Fırça ile Shift / Ctrl</translation>
    </message>
    <message>
        <source>Shift and drag, or middle drag</source>
        <translation>Shift ile ya da orta düğmeyle sürükleme</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Tümünü göster</translation>
    </message>
    <message>
        <source>Show the distance as colours</source>
        <translation>Uzaklığı renklerle göster</translation>
    </message>
    <message>
        <source>Show the last seconds</source>
        <translation>Son saniyeleri göster</translation>
    </message>
    <message>
        <source>Show whole runs</source>
        <translation>Bütün çalışmaları göster</translation>
    </message>
    <message>
        <source>Simple tissue</source>
        <translation>Basit doku</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Boyut</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Daha küçük fırça</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>En küçük açı</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Yumuşak kenar</translation>
    </message>
    <message>
        <source>Soft-tissue organ models that surgeons in training can feel.</source>
        <translation>Eğitimdeki cerrahların dokunabildiği yumuşak doku organ modelleri.</translation>
    </message>
    <message>
        <source>Something went wrong in the editor itself ({what}). Your work is still here: save it, and please report this.</source>
        <translation>Düzenleyicinin kendisinde bir şey ters gitti ({what}). Çalışmanız duruyor: kaydedin ve lütfen bunu bildirin.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kaynak</translation>
    </message>
    <message>
        <source>Space starts.</source>
        <translation>Boşluk tuşu başlatır.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hız</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Dalak</translation>
    </message>
    <message>
        <source>Springs and bonds</source>
        <translation>Yaylar ve bağlar</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Kararlılık</translation>
    </message>
    <message>
        <source>Stability margin</source>
        <translation>Kararlılık payı</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Aşama</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Aşamalar</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Başlat</translation>
    </message>
    <message>
        <source>Stiff&amp;ness</source>
        <translation>&amp;Katılık</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Katılık</translation>
    </message>
    <message>
        <source>Stiffness in the middle of the brush, times the organ's</source>
        <translation>Fırçanın ortasındaki katılık, organınkinin katı olarak</translation>
    </message>
    <message>
        <source>Stiffness map</source>
        <translation>Katılık haritası</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Mide</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Durdur</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Güç</translation>
    </message>
    <message>
        <source>Stretches like</source>
        <translation>Uzaması benzer:</translation>
    </message>
    <message>
        <source>Substeps a tick</source>
        <translation>Adım başına alt adım</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Yüzey</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tablo (*.csv)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Geri yükle</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Hedef</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Görev</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Dene</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Dörtyüzlü</translation>
    </message>
    <message>
        <source>The device failed ({what}): the run was stopped.</source>
        <translation>Cihaz arızalandı ({what}): çalışma durduruldu.</translation>
    </message>
    <message>
        <source>The editor ended without saving {name}, changed at {time}.</source>
        <translation>Düzenleyici, {time} tarihinde değişen {name} kaydedilmeden kapandı.</translation>
    </message>
    <message>
        <source>The editor is free software under the GNU General Public License 3 or later; what it publishes is yours.</source>
        <translation>Düzenleyici, GNU Genel Kamu Lisansı 3 veya sonrası altında özgür yazılımdır; yayımladıkları sizindir.</translation>
    </message>
    <message>
        <source>The forces were not exported: {problem}</source>
        <translation>Kuvvetler dışa aktarılamadı: {problem}</translation>
    </message>
    <message>
        <source>The loop has a millisecond for every tick. Fewer vertices leave more of it free; 600 to 2400 are usual. The colours show how far the new surface is from the file.</source>
        <translation>Döngünün her adım için bir milisaniyesi vardır. Daha az köşe daha çok zaman bırakır; 600–2400 olağandır. Renkler yeni yüzeyin dosyadan ne kadar uzak olduğunu gösterir.</translation>
    </message>
    <message>
        <source>The mass–spring model has springs along all edges. The molecular model adds angles and their coupling to stretch; a triangle can only take a certain range of it.</source>
        <translation>Kütle–yay modelinde tüm kenarlarda yay vardır. Moleküler model açıları ve gerilmeyle bağlaşımlarını ekler; bir üçgen bunun ancak belli bir aralığını kaldırır.</translation>
    </message>
    <message>
        <source>The material is on the clipboard.</source>
        <translation>Malzeme panoda.</translation>
    </message>
    <message>
        <source>The memory of a linear solid grows with what can be pushed: name a region, and elsewhere it does not give.</source>
        <translation>Doğrusal dolu cismin belleği, itilebilen yüzeyle büyür: bir bölge seçilirse öbür yerler esnemez.</translation>
    </message>
    <message>
        <source>The mouse is the hand: move over the organ, hold the left button to press, and turn the wheel to press deeper. The right button, or Ctrl, takes hold and pulls.</source>
        <translation>Fare eldir: organın üzerinde gezdirin, basmak için sol düğmeyi tutun, daha derine basmak için tekerleği çevirin. Sağ düğme ya da Ctrl tutar ve çeker.</translation>
    </message>
    <message>
        <source>The organ cannot be tested yet.</source>
        <translation>Organ henüz denenemez.</translation>
    </message>
    <message>
        <source>The organ cannot be tested yet: got {got}, expected {expected}.</source>
        <translation>Organ henüz denenemez: bulunan {got}, beklenen {expected}.</translation>
    </message>
    <message>
        <source>The organ has weight (9.81 m/s² downwards)</source>
        <translation>Organın ağırlığı var (aşağı doğru 9,81 m/s²)</translation>
    </message>
    <message>
        <source>The organ is being checked: one moment.</source>
        <translation>Organ denetleniyor: bir an.</translation>
    </message>
    <message>
        <source>The organ was felt as it is now.</source>
        <translation>Organ şimdiki hâliyle hissedildi.</translation>
    </message>
    <message>
        <source>The tool reaches</source>
        <translation>Aletin eriştiği yer</translation>
    </message>
    <message>
        <source>The window could not be started.</source>
        <translation>Pencere başlatılamadı.</translation>
    </message>
    <message>
        <source>The window ended: {reason}</source>
        <translation>Pencere kapandı: {reason}</translation>
    </message>
    <message>
        <source>The run was stopped because the organ was changed. Start it again.</source>
        <translation>Organ değiştiği için çalışma durduruldu. Yeniden başlatın.</translation>
    </message>
    <message>
        <source>The same press from a command line, once published</source>
        <translation>Yayımlandıktan sonra aynı bası komut satırından</translation>
    </message>
    <message>
        <source>The same run again, from rest</source>
        <translation>Aynı çalışma yeniden, dinlenmeden</translation>
    </message>
    <message>
        <source>The surface does not cross itself.</source>
        <translation>Yüzey kendisiyle kesişmiyor.</translation>
    </message>
    <message>
        <source>The surface is closed: it can be a solid organ.</source>
        <translation>Yüzey kapalı: dolu bir organ olabilir.</translation>
    </message>
    <message>
        <source>The surface now</source>
        <translation>Şimdiki yüzey</translation>
    </message>
    <message>
        <source>The time step as a share of the longest stable one: beyond 100 % the tissue blows up. Substeps are chosen so that it stays below.</source>
        <translation>En uzun kararlı adımın payı olarak zaman adımı: yüzde 100'ün ötesinde doku patlar. Alt adımlar bunun altında kalacak biçimde seçilir.</translation>
    </message>
    <message>
        <source>The run was stopped after {time:.2f} s: {what}.</source>
        <translation>Çalışma {time:.2f} s sonra durduruldu: {what}.</translation>
    </message>
    <message>
        <source>The tissue can be built and stays stable.</source>
        <translation>Doku kurulabiliyor ve kararlı kalıyor.</translation>
    </message>
    <message>
        <source>The loop that a haptic device will run, with your mouse as the hand. The left button presses, the right one takes hold, the wheel goes deeper.</source>
        <translation>Bir haptik cihazın çalıştıracağı döngünün kendisi; fareniz el yerine geçer. Sol düğme basar, sağ düğme tutar, tekerlek derine iner.</translation>
    </message>
    <message>
        <source>Then click on the organ where the tip shall press</source>
        <translation>Sonra ucun basacağı yere organın üzerinde tıklayın</translation>
    </message>
    <message>
        <source>Then it grips and pulls this far above</source>
        <translation>Sonra tutar ve bu kadar yukarı çeker</translation>
    </message>
    <message>
        <source>There is no material on the clipboard: copy one first.</source>
        <translation>Panoda malzeme yok: önce bir tane kopyalayın.</translation>
    </message>
    <message>
        <source>There is no organ to test yet: import a mesh file first.</source>
        <translation>Henüz denenecek organ yok: önce bir ağ dosyası içe aktarın.</translation>
    </message>
    <message>
        <source>There is no run to export yet: press the organ first.</source>
        <translation>Henüz dışa aktarılacak çalışma yok: önce organa basın.</translation>
    </message>
    <message>
        <source>There is no run to save yet.</source>
        <translation>Henüz kaydedilecek çalışma yok.</translation>
    </message>
    <message>
        <source>There is nothing to publish yet: import a mesh first.</source>
        <translation>Henüz yayımlanacak bir şey yok: önce bir ağ içe aktarın.</translation>
    </message>
    <message>
        <source>These five give the wall its stretching and its bending; nothing else need be chosen.</source>
        <translation>Bu beşi duvarın uzamasını ve eğilmesini verir; başka bir şey seçmek gerekmez.</translation>
    </message>
    <message>
        <source>This needs more memory than the machine has.</source>
        <translation>Bu, makinedekinden çok bellek istiyor.</translation>
    </message>
    <message>
        <source>This organ</source>
        <translation>Bu organ</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Tick</source>
        <translation>Adım</translation>
    </message>
    <message>
        <source>Ticks left out because the one before took too long, of all ticks.</source>
        <translation>Önceki çok uzun sürdüğü için atlanan adımlar, tüm adımlar içinde.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zaman</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zaman [s]</translation>
    </message>
    <message>
        <source>Time at the deepest and highest point</source>
        <translation>En derin ve en yüksek noktada bekleme</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Uç</translation>
    </message>
    <message>
        <source>Tip of the tool</source>
        <translation>Aletin ucu</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Doku</translation>
    </message>
    <message>
        <source>Tissue to look up</source>
        <translation>Bakılacak doku</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Başlık</translation>
    </message>
    <message>
        <source>Tool and hand</source>
        <translation>Alet ve el</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Araçlar</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Tepe</translation>
    </message>
    <message>
        <source>Total mass</source>
        <translation>Toplam kütle</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Üçgenler</translation>
    </message>
    <message>
        <source>Triangles are well shaped.</source>
        <translation>Üçgenler düzgün biçimli.</translation>
    </message>
    <message>
        <source>Triangles face</source>
        <translation>Üçgenlerin yönü</translation>
    </message>
    <message>
        <source>Triangles of no area, removed</source>
        <translation>Silinen alansız üçgenler</translation>
    </message>
    <message>
        <source>Triangles there twice, removed</source>
        <translation>Silinen yinelenmiş üçgenler</translation>
    </message>
    <message>
        <source>Triangles turned round</source>
        <translation>Çevrilen üçgenler</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Birim</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Kaydedilmemiş değişiklikler</translation>
    </message>
    <message>
        <source>Unsaved work was found</source>
        <translation>Kaydedilmemiş çalışma bulundu</translation>
    </message>
    <message>
        <source>Use the imported surface</source>
        <translation>İçe aktarılan yüzeyi kullan</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Köşeler</translation>
    </message>
    <message>
        <source>Vertices of no triangle, removed</source>
        <translation>Silinen üçgensiz köşeler</translation>
    </message>
    <message>
        <source>Vertices split</source>
        <translation>Bölünen köşeler</translation>
    </message>
    <message>
        <source>Vertices welded</source>
        <translation>Kaynaştırılan köşeler</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Hacim</translation>
    </message>
    <message>
        <source>Welding, repairing and inspecting {file}</source>
        <translation>{file} kaynaştırılıyor, onarılıyor ve inceleniyor</translation>
    </message>
    <message>
        <source>What comes of it</source>
        <translation>Ortaya çıkan</translation>
    </message>
    <message>
        <source>What holds it</source>
        <translation>Onu tutan</translation>
    </message>
    <message>
        <source>What is published</source>
        <translation>Yayımlanan</translation>
    </message>
    <message>
        <source>What the trainee reads</source>
        <translation>Eğitim görenin okuduğu</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Bulunanlar</translation>
    </message>
    <message>
        <source>What would you like to do?</source>
        <translation>Ne yapmak istersiniz?</translation>
    </message>
    <message>
        <source>What you do appears here as a command line.</source>
        <translation>Yaptıklarınız burada komut satırı olarak görünür.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Tekerlek</translation>
    </message>
    <message>
        <source>Write one file that a trainee can open and feel.</source>
        <translation>Eğitim görenin açıp dokunabileceği tek bir dosya yazın.</translation>
    </message>
    <message>
        <source>Its response</source>
        <translation>Tepkisi</translation>
    </message>
    <message>
        <source>Young's modulus and Poisson's ratio give springs and volumes their constants; nothing else need be chosen.</source>
        <translation>Young modülü ve Poisson oranı yayların ve hacimlerin sabitlerini verir; başka bir şey seçmek gerekmez.</translation>
    </message>
    <message>
        <source>Young's modulus and Poisson's ratio are its law. It is good for presses of up to {share} % of the thickness; a deeper one ends the run.</source>
        <translation>Yasasını Young modülü ve Poisson oranı verir. Kalınlığın %{share} kadarına varan bastırmalar için geçerlidir; daha derini çalışmayı bitirir.</translation>
    </message>
    <message>
        <source>Young's modulus and Poisson's ratio are its law for small strains; it may be strained and turned far. It runs in plain code, which takes longer than springs do.</source>
        <translation>Young modülü ile Poisson oranı küçük gerinimlerde onun yasasıdır; çok gerilebilir ve çok dönebilir. Düz kodla çalışır, bu da yaylardan uzun sürer.</translation>
    </message>
    <message>
        <source>Young's modulus, Poisson's ratio and the wall's thickness give every spring and bond its constants. Choose them by hand to go on from there.</source>
        <translation>Young modülü, Poisson oranı ve duvar kalınlığı her yayın ve bağın sabitlerini verir. Oradan devam etmek için sabitleri elle seçin.</translation>
    </message>
    <message>
        <source>about {share} % of its time</source>
        <translation>zamanının yaklaşık %{share} kadarı</translation>
    </message>
    <message>
        <source>an organ without a name</source>
        <translation>adsız bir organ</translation>
    </message>
    <message>
        <source>autosaved {time}</source>
        <translation>otomatik kayıt {time}</translation>
    </message>
    <message>
        <source>back to Orbit</source>
        <translation>Yörünge'ye dön</translation>
    </message>
    <message>
        <source>brush {mm:.1f} mm ({px:.0f} px)</source>
        <translation>fırça {mm:.1f} mm ({px:.0f} px)</translation>
    </message>
    <message>
        <source>centimetre (cm)</source>
        <translation>santimetre (cm)</translation>
    </message>
    <message>
        <source>displacement [mm]</source>
        <translation>yer değiştirme [mm]</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>içi boş</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>boşta</translation>
    </message>
    <message>
        <source>inch (in)</source>
        <translation>inç (in)</translation>
    </message>
    <message>
        <source>inwards</source>
        <translation>içe</translation>
    </message>
    <message>
        <source>it said nothing</source>
        <translation>bir şey söylemedi</translation>
    </message>
    <message>
        <source>metre (m)</source>
        <translation>metre (m)</translation>
    </message>
    <message>
        <source>millimetre (mm)</source>
        <translation>milimetre (mm)</translation>
    </message>
    <message>
        <source>move</source>
        <translation>taşıma</translation>
    </message>
    <message>
        <source>none at rest</source>
        <translation>durgunken yok</translation>
    </message>
    <message>
        <source>none, it is closed</source>
        <translation>yok, kapalı</translation>
    </message>
    <message>
        <source>outwards</source>
        <translation>dışa</translation>
    </message>
    <message>
        <source>own value</source>
        <translation>kendi değeri</translation>
    </message>
    <message>
        <source>see the checks below</source>
        <translation>aşağıdaki denetimlere bakın</translation>
    </message>
    <message>
        <source>size of the brush</source>
        <translation>fırçanın boyutu</translation>
    </message>
    <message>
        <source>smooth / erase</source>
        <translation>yumuşat / sil</translation>
    </message>
    <message>
        <source>stiffness factor</source>
        <translation>katılık çarpanı</translation>
    </message>
    <message>
        <source>the top</source>
        <translation>tepe</translation>
    </message>
    <message>
        <source>too many to count</source>
        <translation>sayılamayacak kadar çok</translation>
    </message>
    <message>
        <source>triangle {number}   x {x}  y {y}  z {z} mm</source>
        <translation>üçgen {number}   x {x}  y {y}  z {z} mm</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>döndürme</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>düzgün dağılım</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>adsız</translation>
    </message>
    <message>
        <source>zoom to the pointer</source>
        <translation>imlece yakınlaştırma</translation>
    </message>
    <message>
        <source>1 error to fix</source>
        <translation>düzeltilecek 1 hata</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 uyarı</translation>
    </message>
    <message>
        <source>{count} errors to fix</source>
        <translation>düzeltilecek {count} hata</translation>
    </message>
    <message>
        <source>{count} warnings</source>
        <translation>{count} uyarı</translation>
    </message>
    <message>
        <source>{count} vertices</source>
        <translation>{count} köşe</translation>
    </message>
    <message>
        <source>{problems}: see Problems.</source>
        <translation>{problems}: Sorunlar bölümüne bakın.</translation>
    </message>
    <message>
        <source>{file} could not be written.</source>
        <translation>{file} yazılamadı.</translation>
    </message>
    <message>
        <source>{file} imported: {vertices} vertices, {triangles} triangles.</source>
        <translation>{file} içe aktarıldı: {vertices} köşe, {triangles} üçgen.</translation>
    </message>
    <message>
        <source>{file} is no longer where it was: choose it again.</source>
        <translation>{file} artık yerinde değil: yeniden seçin.</translation>
    </message>
    <message>
        <source>There is no file {file}.</source>
        <translation>{file} adında bir dosya yok.</translation>
    </message>
    <message>
        <source>{file}: the editor opens .organ and .palpate files and imports {meshes}.</source>
        <translation>{file}: düzenleyici .organ ve .palpate dosyalarını açar, {meshes} dosyalarını içe aktarır.</translation>
    </message>
    <message>
        <source>{fixed} of {all} vertices are fixed; {painted} have a stiffness of their own.</source>
        <translation>{all} köşenin {fixed} tanesi sabit; {painted} tanesinin kendi katılığı var.</translation>
    </message>
    <message>
        <source>{got}.
Expected: {expected}.</source>
        <translation>{got}.
Beklenen: {expected}.</translation>
    </message>
    <message>
        <source>{median:.0f} % of a tick, p99 {p99:.0f} %</source>
        <translation>bir adımın %{median:.0f} kadarı, p99 %{p99:.0f}</translation>
    </message>
    <message>
        <source>{memory} for {pushed} of {moved} particles</source>
        <translation>{memory}; {moved} parçacığın {pushed} tanesi için</translation>
    </message>
    <message>
        <source>{memory}, being solved for</source>
        <translation>{memory}, hesaplanıyor</translation>
    </message>
    <message>
        <source>{name} has changes that are not saved.</source>
        <translation>{name} kaydedilmemiş değişiklikler içeriyor.</translation>
    </message>
    <message>
        <source>{name} must lie between {low:g} and {high:g} {unit}, got {got:g}.</source>
        <translation>{name}, {low:g} ile {high:g} {unit} arasında olmalı; verilen {got:g}.</translation>
    </message>
    <message>
        <source>{problem} Choose fewer of its parts at the right.</source>
        <translation>{problem} Sağda daha az parça seçin.</translation>
    </message>
    <message>
        <source>{rate} fps</source>
        <translation>{rate} kare/s</translation>
    </message>
    <message>
        <source>{some} of {all} vertices fixed</source>
        <translation>{all} köşenin {some} tanesi sabit</translation>
    </message>
    <message>
        <source>{some} of {all} vertices painted</source>
        <translation>{all} köşenin {some} tanesi boyalı</translation>
    </message>
    <message>
        <source>{some} of {all} vertices selected</source>
        <translation>{all} köşenin {some} tanesi seçili</translation>
    </message>
    <message>
        <source>{used} of {all} parts are in use.</source>
        <translation>{all} parçanın {used} tanesi kullanılıyor.</translation>
    </message>
    <message>
        <source>{vertices} vertices</source>
        <translation>{vertices} köşe</translation>
    </message>
    <message>
        <source>{vertices} vertices · {triangles} triangles</source>
        <translation>{vertices} köşe · {triangles} üçgen</translation>
    </message>
    <message>
        <source>{work} is still under way: wait for it, or cancel it below.</source>
        <translation>{work}: hâlâ sürüyor; bekleyin ya da aşağıdan vazgeçin.</translation>
    </message>
    <message>
        <source>{work}: cancelled, nothing has changed.</source>
        <translation>{work}: vazgeçildi, hiçbir şey değişmedi.</translation>
    </message>
    <message>
        <source>The file has changed</source>
        <translation>Dosya değişmiş</translation>
    </message>
    <message>
        <source>{file} was changed by another program after it was read here.</source>
        <translation>{file}, burada okunduktan sonra başka bir program tarafından değiştirildi.</translation>
    </message>
    <message>
        <source>Overwriting loses what the other program wrote; reading it again loses what was changed here. Under another name both are kept.</source>
        <translation>Üzerine yazarsanız diğer programın yazdıkları, yeniden okursanız buradaki değişiklikler kaybolur. Başka bir adla kaydederseniz ikisi de kalır.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Farklı kaydet…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Üzerine yaz</translation>
    </message>
    <message>
        <source>Read it again</source>
        <translation>Yeniden oku</translation>
    </message>
    <message>
        <source>The organ was changed while {file} was read, so it stays: open that again.</source>
        <translation>{file} okunurken organ değiştirildi, bu yüzden organ yerinde kaldı: dosyayı yeniden açın.</translation>
    </message>
    <message>
        <source>{file} is open in another editor too (process {process}): saving asks before it overwrites what was saved there.</source>
        <translation>{file} başka bir düzenleyicide de açık (süreç {process}): kaydederken, orada kaydedilenin üzerine yazmadan önce sorulur.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Görünüm</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Yumuşak doku</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Taş</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Düz</translation>
    </message>
    <message>
        <source>Its own</source>
        <translation>Kendine özgü</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Renk…</translation>
    </message>
    <message>
        <source>Colour of the tissue</source>
        <translation>Doku rengi</translation>
    </message>
    <message>
        <source>Force / depth</source>
        <translation>Kuvvet / derinlik</translation>
    </message>
    <message>
        <source>not at rest: hold longer</source>
        <translation>durulmadı: daha uzun bekletin</translation>
    </message>
    <message>
        <source>Force / depth, at rest</source>
        <translation>Kuvvet / derinlik, durgun</translation>
    </message>
    <message>
        <source>Fill these</source>
        <translation>Bunları doldur</translation>
    </message>
    <message>
        <source>Fill all holes</source>
        <translation>Tüm delikleri doldur</translation>
    </message>
    <message>
        <source>{count} holes of {edges} edges</source>
        <translation>{edges} kenarlı {count} delik</translation>
    </message>
    <message>
        <source>Hole of {edges} edges</source>
        <translation>{edges} kenarlı delik</translation>
    </message>
    <message>
        <source>{size} wide</source>
        <translation>{size} genişlikte</translation>
    </message>
    <message>
        <source>{count}, kept open</source>
        <translation>{count}, açık bırakıldı</translation>
    </message>
    <message>
        <source>cannot be told: edges have more than two triangles</source>
        <translation>söylenemez: kenarlarda ikiden çok üçgen var</translation>
    </message>
    <message>
        <source>cannot be told: an open surface has no inside</source>
        <translation>söylenemez: açık bir yüzeyin içi yoktur</translation>
    </message>
    <message>
        <source>cannot be told: neighbours do not agree</source>
        <translation>söylenemez: komşu üçgenler uyuşmuyor</translation>
    </message>
    <message>
        <source>Find a part by its name</source>
        <translation>Parçayı adıyla bul</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Göster</translation>
    </message>
    <message>
        <source>The ticked parts in the view; the one under the pointer stands out</source>
        <translation>İşaretli parçalar görünümde; imlecin altındaki öne çıkar</translation>
    </message>
    <message>
        <source>{vertices} vertices, {triangles} △, {size} mm</source>
        <translation>{vertices} köşe, {triangles} △, {size} mm</translation>
    </message>
    <message>
        <source>A tissue needs a clean surface. Holes stay open until you fill them.</source>
        <translation>Doku temiz bir yüzey ister. Delikler siz doldurana kadar açık kalır.</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>&amp;Dolu cisim</translation>
    </message>
    <message>
        <source>L&amp;inear solid</source>
        <translation>Doğr&amp;usal dolu cisim</translation>
    </message>
    <message>
        <source>&amp;Corotated solid</source>
        <translation>&amp;Eşdöner dolu cisim</translation>
    </message>
    <message>
        <source>&amp;Neo-Hookean solid</source>
        <translation>&amp;Neo-Hooke dolu cisim</translation>
    </message>
    <message>
        <source>A published value needs a number.</source>
        <translation>Yayımlanmış bir değer için bir sayı gerekir.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ekle</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Kaldır</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Sabit</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Aralık</translation>
    </message>
    <message>
        <source>Measured by</source>
        <translation>Ölçüm yöntemi</translation>
    </message>
    <message>
        <source>Source: authors, journal, year</source>
        <translation>Kaynak: yazarlar, dergi, yıl</translation>
    </message>
    <message>
        <source>Springs and bonds take the stiffness below, so Young's modulus and Poisson's ratio have no effect. They count in a solid, and in a wall that has a thickness.</source>
        <translation>Yaylar ve bağlar aşağıdaki katılığı alır; bu yüzden Young modülü ile Poisson oranının etkisi yoktur. Dolu cisimde ve kalınlığı olan bir duvarda sayılırlar.</translation>
    </message>
    <message>
        <source>Springs and bonds take the stiffness below. Young's modulus sets the home springs of a hollow organ where they have no own value, and what its wall is compared with.</source>
        <translation>Yaylar ve bağlar aşağıdaki katılığı alır. Young modülü, kendi değeri yoksa içi boş bir organın yuva yaylarını ve duvarının neyle karşılaştırılacağını belirler.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Kullan</translation>
    </message>
    <message>
        <source>Use the constants of this tissue</source>
        <translation>Bu dokunun sabitlerini kullan</translation>
    </message>
    <message>
        <source>Values that ship with Palpate stay; choose one of your own.</source>
        <translation>Palpate ile gelen değerler kalır; kendi eklediğiniz birini seçin.</translation>
    </message>
    <message>
        <source>Values…</source>
        <translation>Değerler…</translation>
    </message>
    <message>
        <source>What the literature says, and what you add to it</source>
        <translation>Yayınların verdikleri ve sizin ekledikleriniz</translation>
    </message>
    <message>
        <source>done again: {edit}</source>
        <translation>yinelendi: {edit}</translation>
    </message>
    <message>
        <source>undone: {edit}</source>
        <translation>geri alındı: {edit}</translation>
    </message>
    <message>
        <source>{edit}: no command does this</source>
        <translation>{edit}: bunu yapan bir komut yok</translation>
    </message>
    <message>
        <source>Language of title and task</source>
        <translation>Başlık ve görevin dili</translation>
    </message>
    <message>
        <source>A trainee reads the translation of the window's language, if any</source>
        <translation>Eğitim alan kişi, varsa, pencerenin dilindeki çeviriyi okur</translation>
    </message>
    <message>
        <source>In every language</source>
        <translation>Her dilde</translation>
    </message>
    <message>
        <source>In {name}</source>
        <translation>Dili: {name}</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>karaciğer</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>dalak</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>böbrek</translation>
    </message>
    <message>
        <source>gallbladder wall</source>
        <translation>safra kesesi duvarı</translation>
    </message>
    <message>
        <source>stomach wall</source>
        <translation>mide duvarı</translation>
    </message>
    <message>
        <source>soft patch</source>
        <translation>yumuşak yama</translation>
    </message>
    <message>
        <source>kidney stone</source>
        <translation>böbrek taşı</translation>
    </message>
    <message>
        <source>Springs and bonds take the stiffness below, and home springs their own value, so Young's modulus and Poisson's ratio have no effect on the force: the wall is only compared with them.</source>
        <translation>Yaylar ve bağlar aşağıdaki katılığı, yuva yayları kendi değerlerini alır; bu yüzden Young modülünün ve Poisson oranının kuvvete etkisi yoktur: duvar yalnızca onlarla karşılaştırılır.</translation>
    </message>
    <message>
        <source>A tick in touch takes</source>
        <translation>Temasta bir adım süresi</translation>
    </message>
    <message>
        <source>For comparison</source>
        <translation>Karşılaştırma için</translation>
    </message>
    <message>
        <source>For comparison: {error}.</source>
        <translation>Karşılaştırma için: {error}.</translation>
    </message>
    <message>
        <source>Home springs carry</source>
        <translation>Yuva yaylarının payı</translation>
    </message>
    <message>
        <source>{span} % of the force</source>
        <translation>kuvvetin %{span} kadarı</translation>
    </message>
    <message>
        <source>Substeps in touch</source>
        <translation>Temasta alt adım</translation>
    </message>
    <message>
        <source>Has no effect here: {why}. {where}</source>
        <translation>Burada etkisi yoktur: {why}. {where}</translation>
    </message>
    <message>
        <source>Validated to</source>
        <translation>Doğrulanan derinlik</translation>
    </message>
    <message>
        <source>no depth: only balls of {least} to {most} mm are</source>
        <translation>yok: yalnız {least} ile {most} mm arası küreler için var</translation>
    </message>
    <message>
        <source>{span} mm deep, by place</source>
        <translation>yerine göre {span} mm</translation>
    </message>
    <message>
        <source>The press stays within the {depth} mm that are validated there.</source>
        <translation>Basış, orada doğrulanmış olan {depth} mm içinde kalıyor.</translation>
    </message>
    <message>
        <source>Feel it as on tissue</source>
        <translation>Dokudaki gibi hissedilsin</translation>
    </message>
    <message>
        <source>Contact as on the mesh, which files of before have, lets the mesh be felt. A hand that presses {depth} deep feels by either law:</source>
        <translation>Önceki dosyaların yasası olan ağdaki gibi temas, ağı hissettirir. {depth} derine basan elin iki yasayla duyduğu:</translation>
    </message>
    <message>
        <source>Place [mm]</source>
        <translation>Yer [mm]</translation>
    </message>
    <message>
        <source>A tick in touch</source>
        <translation>Temasta bir adım</translation>
    </message>
    <message>
        <source>Charts (*.json)</source>
        <translation>Çizelgeler (*.json)</translation>
    </message>
    <message>
        <source>Click on a point to read what it is, and to simulate the organ so.</source>
        <translation>Ne olduğunu okumak ve organı öyle canlandırmak için bir noktaya tıklayın.</translation>
    </message>
    <message>
        <source>Force error, of the largest force</source>
        <translation>Kuvvet hatası, en büyük kuvvete göre</translation>
    </message>
    <message>
        <source>No chart yet: draw one of this organ, or open one</source>
        <translation>Henüz çizelge yok: bu organınkini çizin ya da bir çizelge açın</translation>
    </message>
    <message>
        <source>Open a chart</source>
        <translation>Çizelge aç</translation>
    </message>
    <message>
        <source>Open a chart…</source>
        <translation>Çizelge aç…</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Çizelgeyi kaydet</translation>
    </message>
    <message>
        <source>Save the chart…</source>
        <translation>Çizelgeyi kaydet…</translation>
    </message>
    <message>
        <source>Simulate it so</source>
        <translation>Böyle canlandır</translation>
    </message>
    <message>
        <source>So it is simulated now.</source>
        <translation>Şu anda böyle canlandırılıyor.</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Hız ve doğruluk</translation>
    </message>
    <message>
        <source>a tick</source>
        <translation>bir adım</translation>
    </message>
    <message>
        <source>did not run to the end</source>
        <translation>sonuna kadar gitmedi</translation>
    </message>
    <message>
        <source>not timed yet</source>
        <translation>süresi henüz ölçülmedi</translation>
    </message>
    <message>
        <source>target</source>
        <translation>hedef</translation>
    </message>
    <message>
        <source>the truth's own error</source>
        <translation>gerçeğin kendi hatası</translation>
    </message>
    <message>
        <source>▲ another explicit step, ■ an implicit one; hollow: chosen constants, or the hard law of contact</source>
        <translation>▲ başka bir açık adım, ■ kapalı bir adım; içi boş: elle seçilmiş sabitler ya da sert temas yasası</translation>
    </message>
    <message>
        <source>Speed and &amp;accuracy…</source>
        <translation>Hız ve &amp;doğruluk…</translation>
    </message>
    <message>
        <source>&amp;Open a chart…</source>
        <translation>Çi&amp;zelge aç…</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Göster</translation>
    </message>
    <message>
        <source>Whatever can be drawn is imported. Triangles that no tissue can be built on are red on the organ, and the checks below name what repairs them.</source>
        <translation>Çizilebilen her şey içe aktarılır. Üzerine doku kurulamayan üçgenler organda kırmızıdır; onları neyin onaracağını aşağıdaki denetimler söyler.</translation>
    </message>
    <message>
        <source>All of the organ</source>
        <translation>Organın tümü</translation>
    </message>
    <message>
        <source>In, at a rate of</source>
        <translation>Nerede, ne hızla</translation>
    </message>
    <message>
        <source>Region {name}</source>
        <translation>Bölge {name}</translation>
    </message>
    <message>
        <source>Search…</source>
        <translation>Ara…</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Durum</translation>
    </message>
    <message>
        <source>Use it although nobody has looked it up</source>
        <translation>Kaynağına bakılmamış olsa da kullan</translation>
    </message>
    <message>
        <source>Where the tissue is used</source>
        <translation>Dokunun kullanılacağı yer</translation>
    </message>
    <message>
        <source>Words of the tissue</source>
        <translation>Dokuyu anlatan sözcükler</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>bakıldı</translation>
    </message>
    <message>
        <source>checked in its source</source>
        <translation>kaynağına bakıldı</translation>
    </message>
    <message>
        <source>recalled</source>
        <translation>bellekten</translation>
    </message>
    <message>
        <source>recalled, not looked up: no default</source>
        <translation>bellekten, kaynağına bakılmadı: varsayılan değil</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>bilinmiyor</translation>
    </message>
    <message>
        <source>unknown: no default</source>
        <translation>bilinmiyor: varsayılan değil</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>sizin</translation>
    </message>
    <message>
        <source>{span} published; {status}</source>
        <translation>yayımlanmış: {span}; {status}</translation>
    </message>
    <message>
        <source>All grey levels</source>
        <translation>Bütün gri düzeyler</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Aksiyel</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Kemik</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Cutting the surface out of {file}</source>
        <translation>{file} içinden yüzey çıkarılıyor</translation>
    </message>
    <message>
        <source>From a scan</source>
        <translation>Taramadan</translation>
    </message>
    <message>
        <source>From a scan…</source>
        <translation>Taramadan…</translation>
    </message>
    <message>
        <source>From grey level</source>
        <translation>Başlangıç gri düzeyi</translation>
    </message>
    <message>
        <source>Grey levels that are shown</source>
        <translation>Gösterilen gri düzeyler</translation>
    </message>
    <message>
        <source>Import from a s&amp;can…</source>
        <translation>&amp;Taramadan içe aktar…</translation>
    </message>
    <message>
        <source>Import from a scan</source>
        <translation>Taramadan içe aktar</translation>
    </message>
    <message>
        <source>It ends where the scan does, and is closed there flat.</source>
        <translation>Taramanın bittiği yerde biter ve orada düz kapatılır.</translation>
    </message>
    <message>
        <source>Labels of the organ</source>
        <translation>Organın etiketleri</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Düzey</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Akciğer</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Önizle</translation>
    </message>
    <message>
        <source>Repairing the surface</source>
        <translation>Yüzey onarılıyor</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Scans ({names})</source>
        <translation>Taramalar ({names})</translation>
    </message>
    <message>
        <source>Slice, {plane}</source>
        <translation>Kesit, {plane}</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Yumuşatma</translation>
    </message>
    <message>
        <source>Smoothing changes the volume by {share}.</source>
        <translation>Yumuşatma hacmi {share} değiştirir.</translation>
    </message>
    <message>
        <source>The gantry was tilted by {angle}.</source>
        <translation>Tarayıcı {angle} eğikti.</translation>
    </message>
    <message>
        <source>The largest piece alone</source>
        <translation>Yalnız en büyük parça</translation>
    </message>
    <message>
        <source>To grey level</source>
        <translation>Bitiş gri düzeyi</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Pencere</translation>
    </message>
    <message>
        <source>label {number}</source>
        <translation>etiket {number}</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>voksel</translation>
    </message>
    <message>
        <source>{count} smaller pieces are left out.</source>
        <translation>{count} küçük parça dışarıda kaldı.</translation>
    </message>
    <message>
        <source>{vertices} vertices, {triangles} triangles, {volume}</source>
        <translation>{vertices} köşe, {triangles} üçgen, {volume}</translation>
    </message>
    <message>
        <source>micrometre (µm)</source>
        <translation>mikrometre (µm)</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Öneri</translation>
    </message>
    <message>
        <source>Advise</source>
        <translation>Öner</translation>
    </message>
    <message>
        <source>Advising</source>
        <translation>Öneriliyor</translation>
    </message>
    <message>
        <source>Chart…</source>
        <translation>Çizelge…</translation>
    </message>
    <message>
        <source>Choosing</source>
        <translation>Seçiliyor</translation>
    </message>
    <message>
        <source>Configurations are timed</source>
        <translation>Yapılandırmaların süresi ölçülüyor</translation>
    </message>
    <message>
        <source>Configurations run</source>
        <translation>Yapılandırmalar çalışıyor</translation>
    </message>
    <message>
        <source>Displacement error</source>
        <translation>Yer değiştirme hatası</translation>
    </message>
    <message>
        <source>Pressed or pulled to</source>
        <translation>Basma, çekme derinliği</translation>
    </message>
    <message>
        <source>as charted</source>
        <translation>çizelgedeki kadar</translation>
    </message>
    <message>
        <source>Draw the chart</source>
        <translation>Çizelgeyi çiz</translation>
    </message>
    <message>
        <source>Drawing the chart</source>
        <translation>Çizelge çiziliyor</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Kuvvet hatası</translation>
    </message>
    <message>
        <source>It begins</source>
        <translation>Başlıyor</translation>
    </message>
    <message>
        <source>Models converged in time</source>
        <translation>Zamanda yakınsamış modeller</translation>
    </message>
    <message>
        <source>Presses held out from the choice</source>
        <translation>Seçimden ayrı tutulan basmalar</translation>
    </message>
    <message>
        <source>The cheapest way to simulate this organ that is right and quick enough. Its chart is drawn first where there is none: minutes, and kept.</source>
        <translation>Bu organı yeterince doğru ve hızlı canlandırmanın en ucuz yolu. Çizelgesi yoksa önce o çizilir: dakikalar sürer ve saklanır.</translation>
    </message>
    <message>
        <source>The process that draws the chart ended with code {code}.</source>
        <translation>Çizelgeyi çizen süreç {code} koduyla bitti.</translation>
    </message>
    <message>
        <source>The truth: factors</source>
        <translation>Gerçek: çarpanlara ayırma</translation>
    </message>
    <message>
        <source>The truth: its mesh</source>
        <translation>Gerçek: ağı</translation>
    </message>
    <message>
        <source>The truth: its stiffness</source>
        <translation>Gerçek: katılığı</translation>
    </message>
    <message>
        <source>The truth: responses</source>
        <translation>Gerçek: yanıtlar</translation>
    </message>
    <message>
        <source>There is no organ yet: import a mesh first.</source>
        <translation>Henüz organ yok: önce bir ağ içe aktarın.</translation>
    </message>
    <message>
        <source>Pressing it before and after</source>
        <translation>Öncesine ve sonrasına bastırılıyor</translation>
    </message>
    <message>
        <source>Felt at {depth}</source>
        <translation>{depth} derinlikte hissedilen</translation>
    </message>
    <message>
        <source>What is felt was not compared: {reason}</source>
        <translation>Hissedilen karşılaştırılmadı: {reason}</translation>
    </message>
    <message>
        <source>Nothing was felt at the places that were pressed.</source>
        <translation>Bastırılan yerlerde bir şey hissedilmedi.</translation>
    </message>
    <message>
        <source>Pressed at {places} places: by {change} at most.</source>
        <translation>{places} yere bastırıldı: en çok {change} değişti.</translation>
    </message>
    <message>
        <source>Finer at</source>
        <translation>Daha ince olduğu yer</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Hiçbir yer</translation>
    </message>
    <message>
        <source>Clean up</source>
        <translation>Temizle</translation>
    </message>
    <message>
        <source>Stitch borders</source>
        <translation>Sınırları dik</translation>
    </message>
    <message>
        <source>Drop small pieces</source>
        <translation>Küçük parçaları at</translation>
    </message>
    <message>
        <source>Remove crossings</source>
        <translation>Kesişmeleri gider</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Pürüzsüzleştir</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Yeniden ağla</translation>
    </message>
    <message>
        <source>Wrap, the last resort</source>
        <translation>Sar: son çare</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>Hepsini onar</translation>
    </message>
    <message>
        <source>finer in</source>
        <translation>daha ince:</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>hiçbir yerde</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Adımlar</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Uygula</translation>
    </message>
    <message>
        <source>Preview: {step}</source>
        <translation>Önizleme: {step}</translation>
    </message>
    <message>
        <source>Left as it is:</source>
        <translation>Olduğu gibi kalan:</translation>
    </message>
    <message>
        <source>The organ has changed meanwhile: try the step again.</source>
        <translation>Organ bu arada değişti: adımı yeniden deneyin.</translation>
    </message>
    <message>
        <source>From cleaning to, where nothing else helps, a wrap: says what each step did.</source>
        <translation>Temizlemekten, başka bir şey işe yaramazsa sarmaya kadar: her adımın ne yaptığını söyler.</translation>
    </message>
    <message>
        <source>Each step is shown before it is applied, with what it changes and how far the surface moves. Repair all takes them in turn and says what each did; a wrap, which changes most, comes last and only where nothing else helps.</source>
        <translation>Her adım uygulanmadan önce gösterilir: neyi değiştirdiği ve yüzeyin ne kadar oynadığıyla birlikte. Hepsini onar bunları sırayla yapar ve her birinin ne yaptığını söyler; en çok değiştiren sarma en sonda ve yalnızca başka bir şey işe yaramadığında gelir.</translation>
    </message>
    <message>
        <source>Drop fins</source>
        <translation>Yüzgeçleri at</translation>
    </message>
    <message>
        <source>Angles of triangles</source>
        <translation>Üçgenlerin açıları</translation>
    </message>
    <message>
        <source>Edge of the holes</source>
        <translation>Deliklerin kenarı</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Euler sayısı</translation>
    </message>
    <message>
        <source>Its triangles</source>
        <translation>Üçgenleri</translation>
    </message>
    <message>
        <source>Lengths of edges</source>
        <translation>Kenar uzunlukları</translation>
    </message>
    <message>
        <source>Points where surfaces touch</source>
        <translation>Yüzeylerin değdiği noktalar</translation>
    </message>
    <message>
        <source>Thinnest</source>
        <translation>En ince yeri</translation>
    </message>
    <message>
        <source>{low} to {high}: {count}</source>
        <translation>{low} – {high}: {count}</translation>
    </message>
    <message>
        <source>&amp;Stability…</source>
        <translation>&amp;Kararlılık…</translation>
    </message>
    <message>
        <source>Atlases (*.json)</source>
        <translation>Atlaslar (*.json)</translation>
    </message>
    <message>
        <source>Find the limits</source>
        <translation>Sınırları bul</translation>
    </message>
    <message>
        <source>No atlas yet: find the limits of this organ, or open one</source>
        <translation>Henüz atlas yok: bu organın sınırlarını bulun ya da bir atlas açın</translation>
    </message>
    <message>
        <source>Open an atlas</source>
        <translation>Atlas aç</translation>
    </message>
    <message>
        <source>Open an atlas…</source>
        <translation>Atlas aç…</translation>
    </message>
    <message>
        <source>Save the atlas</source>
        <translation>Atlası kaydet</translation>
    </message>
    <message>
        <source>Save the atlas…</source>
        <translation>Atlası kaydet…</translation>
    </message>
    <message>
        <source>Stiffness, times that of the atlas</source>
        <translation>Sertlik, atlastakinin katı</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zaman adımı</translation>
    </message>
    <message>
        <source>it blows up</source>
        <translation>dağılır</translation>
    </message>
    <message>
        <source>the step holds</source>
        <translation>adım dayanır</translation>
    </message>
    <message>
        <source>{done} of {all} tissues</source>
        <translation>{all} dokudan {done}</translation>
    </message>
    <message>
        <source>{step}: the line was found by running it, dashes are foretold, ★ is this scene</source>
        <translation>{step}: çizgi çalıştırılarak bulundu, kesikli çizgi öngörülen, ★ bu sahne</translation>
    </message>
    <message>
        <source>half steps</source>
        <translation>yarım adımlar</translation>
    </message>
    <message>
        <source>quarter steps</source>
        <translation>çeyrek adımlar</translation>
    </message>
    <message>
        <source>implicit damping</source>
        <translation>örtük sönüm</translation>
    </message>
    <message>
        <source>implicit Euler</source>
        <translation>örtük Euler</translation>
    </message>
    <message>
        <source>Safeguard</source>
        <translation>Güvence</translation>
    </message>
    <message>
        <source>The run would have been stopped after {time:.2f} s: {what}. Shorter or implicit steps held the organ together.</source>
        <translation>Çalışma {time:.2f} s sonra durdurulacaktı: {what}. Organı daha kısa ya da örtük adımlar bir arada tuttu.</translation>
    </message>
    <message>
        <source>Close for filling</source>
        <translation>Doldurmak için kapat</translation>
    </message>
    <message>
        <source>Closes every hole; each cap stays known as a region, so that it can be held.</source>
        <translation>Her deliği kapatır; her kapak bir bölge olarak kalır, böylece sabitlenebilir.</translation>
    </message>
    <message>
        <source>Decimating within {distance}</source>
        <translation>{distance} içinde sadeleştiriliyor</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kenarlar</translation>
    </message>
    <message>
        <source>Edges at the finer region</source>
        <translation>Daha ince bölgedeki kenarlar</translation>
    </message>
    <message>
        <source>Find the count</source>
        <translation>Sayıyı bul</translation>
    </message>
    <message>
        <source>Smallest angle between faces</source>
        <translation>Yüzler arası en küçük açı</translation>
    </message>
    <message>
        <source>The fewest vertices that keep every point of both surfaces within this distance of the other. Takes some ten times as long as one count.</source>
        <translation>Her iki yüzeyin her noktasını diğerine bu uzaklıkta tutan en az köşe sayısı. Tek bir sayıdan yaklaşık on kat uzun sürer.</translation>
    </message>
    <message>
        <source>{least} to {most} mm, {median} in the middle</source>
        <translation>{least} – {most} mm, ortanca {median}</translation>
    </message>
    <message>
        <source>0.6 is a value, 0.4..0.8 is drawn between the two, a; b is one of these</source>
        <translation>0,6 bir değerdir, 0,4..0,8 ikisi arasından çekilir, a; b bunlardan biridir</translation>
    </message>
    <message>
        <source>Add a parameter</source>
        <translation>Parametre ekle</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Düzeyler</translation>
    </message>
    <message>
        <source>Levels and parameters</source>
        <translation>Düzeyler ve parametreler</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>Use it as</source>
        <translation>Şu olarak kullan</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Değer</translation>
    </message>
    <message>
        <source>bound of the limit {name}</source>
        <translation>{name} sınırının değeri</translation>
    </message>
    <message>
        <source>least of the step</source>
        <translation>adımın en azı</translation>
    </message>
    <message>
        <source>most of the step</source>
        <translation>adımın en çoğu</translation>
    </message>
    <message>
        <source>{title}: hands try the task, {hand}</source>
        <translation>{title}: eller görevi deniyor, {hand}</translation>
    </message>
    <message>
        <source>A parameter is a number by name: levels give it other values, or the seed draws it. It can stand for a bound of a step or a limit.</source>
        <translation>Parametre adı olan bir sayıdır: düzeyler ona başka değer verir ya da tohum onu çeker. Bir adımın ya da sınırın değeri yerine geçebilir.</translation>
    </message>
</context>
<context>
    <name>constants</name>
    <message>
        <source>Allowed force error</source>
        <translation>İzin verilen kuvvet hatası</translation>
    </message>
    <message>
        <source>Bend stiffness</source>
        <translation>Eğilme katılığı</translation>
    </message>
    <message>
        <source>Contact stiffness</source>
        <translation>Temas katılığı</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Sönüm oranı</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Yoğunluk</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Sürükleme</translation>
    </message>
    <message>
        <source>Exchange rate</source>
        <translation>Alışveriş hızı</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Gevşeme</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>Gevşeme süresi</translation>
    </message>
    <message>
        <source>Tear stretch</source>
        <translation>Yırtılma uzaması</translation>
    </message>
    <message>
        <source>Grip stiffness</source>
        <translation>Tutma katılığı</translation>
    </message>
    <message>
        <source>Least substeps</source>
        <translation>En az alt adım</translation>
    </message>
    <message>
        <source>Hand coupling</source>
        <translation>El bağlaşımı</translation>
    </message>
    <message>
        <source>Home springs</source>
        <translation>Yuva yayları</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>En büyük kuvvet</translation>
    </message>
    <message>
        <source>Nodal share</source>
        <translation>Düğüm payı</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Poisson oranı</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Basınç</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Katılık</translation>
    </message>
    <message>
        <source>Stretch-bend</source>
        <translation>Gerilme–eğilme</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Dörtyüzlü sayısı</translation>
    </message>
    <message>
        <source>Tick rate</source>
        <translation>Adım hızı</translation>
    </message>
    <message>
        <source>Tip radius</source>
        <translation>Uç yarıçapı</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Duvar kalınlığı</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Young modülü</translation>
    </message>
    <message>
        <source>by kind</source>
        <translation>türe göre</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>dolu</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Constants</source>
        <translation>Sabitler</translation>
    </message>
    <message>
        <source>Rule of springs</source>
        <translation>Yay kuralı</translation>
    </message>
    <message>
        <source>Law of angles</source>
        <translation>Açı yasası</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Sönüm</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Temas</translation>
    </message>
    <message>
        <source>Curvature under the ball</source>
        <translation>Bilye altındaki eğrilik</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Tutulan yer</translation>
    </message>
    <message>
        <source>Mass–spring (MSS)</source>
        <translation>Kütle–yay (MSS)</translation>
    </message>
    <message>
        <source>Molecular (MMS)</source>
        <translation>Moleküler (MMS)</translation>
    </message>
    <message>
        <source>Shell of prisms</source>
        <translation>Prizma kabuk</translation>
    </message>
    <message>
        <source>Solid (MSS+V)</source>
        <translation>Dolu cisim (MSS+V)</translation>
    </message>
    <message>
        <source>Linear solid, shallow presses</source>
        <translation>Doğrusal dolu cisim, sığ bastırma</translation>
    </message>
    <message>
        <source>Corotated solid</source>
        <translation>Eşdöner dolu cisim</translation>
    </message>
    <message>
        <source>Neo-Hookean solid</source>
        <translation>Neo-Hooke dolu cisim</translation>
    </message>
    <message>
        <source>Chosen by hand</source>
        <translation>Elle seçilmiş</translation>
    </message>
    <message>
        <source>From the tissue</source>
        <translation>Dokudan</translation>
    </message>
    <message>
        <source>Van Gelder</source>
        <translation>Van Gelder</translation>
    </message>
    <message>
        <source>Lloyd</source>
        <translation>Lloyd</translation>
    </message>
    <message>
        <source>Energy gradient (Eq 9, 11)</source>
        <translation>Enerji gradyanı (Denk. 9, 11)</translation>
    </message>
    <message>
        <source>Opposite edge (Eq 10)</source>
        <translation>Karşı kenar (Denk. 10)</translation>
    </message>
    <message>
        <source>Along the link</source>
        <translation>Bağlantı boyunca</translation>
    </message>
    <message>
        <source>In all directions</source>
        <translation>Her yönde</translation>
    </message>
    <message>
        <source>As on tissue</source>
        <translation>Dokudaki gibi</translation>
    </message>
    <message>
        <source>As on the mesh</source>
        <translation>Ağdaki gibi</translation>
    </message>
    <message>
        <source>Mean of the vertices</source>
        <translation>Köşelerin ortalaması</translation>
    </message>
    <message>
        <source>Of the triangles</source>
        <translation>Üçgenlerinki</translation>
    </message>
    <message>
        <source>Gives way as tissue</source>
        <translation>Doku gibi esner</translation>
    </message>
    <message>
        <source>Gives way as the mesh</source>
        <translation>Ağ gibi esner</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Zaman adımlayıcı</translation>
    </message>
    <message>
        <source>Symplectic Euler</source>
        <translation>Simplektik Euler</translation>
    </message>
    <message>
        <source>Explicit Euler</source>
        <translation>Açık Euler</translation>
    </message>
    <message>
        <source>Explicit midpoint</source>
        <translation>Açık orta nokta</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>Implicit damping</source>
        <translation>Kapalı sönüm</translation>
    </message>
    <message>
        <source>Implicit Euler, linear</source>
        <translation>Kapalı Euler, doğrusal</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Kapalı Euler</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Kapalı orta nokta</translation>
    </message>
    <message>
        <source>Projective dynamics</source>
        <translation>İzdüşümlü dinamik</translation>
    </message>
    <message>
        <source>XPBD</source>
        <translation>XPBD</translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>Fine size</source>
        <translation>İnce boyut</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Sürtünme</translation>
    </message>
    <message>
        <source>Length that touches</source>
        <translation>Dokunan uzunluk</translation>
    </message>
    <message>
        <source>Trocar height</source>
        <translation>Trokar yüksekliği</translation>
    </message>
    <message>
        <source>Jaw opening</source>
        <translation>Çene açıklığı</translation>
    </message>
    <message>
        <source>Grip force</source>
        <translation>Kavrama kuvveti</translation>
    </message>
</context>
<context>
    <name>edits</name>
    <message>
        <source>Unite the pieces</source>
        <translation>Parçaları birleştir</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>İçe aktarma</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>En büyük parçayı tut</translation>
    </message>
    <message>
        <source>Turn triangles outward</source>
        <translation>Üçgenleri dışa çevir</translation>
    </message>
    <message>
        <source>Use the imported surface</source>
        <translation>İçe aktarılan yüzeyi kullan</translation>
    </message>
    <message>
        <source>Set the appearance</source>
        <translation>Görünümü belirle</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Delikleri doldur</translation>
    </message>
    <message>
        <source>Cut where more than two triangles meet</source>
        <translation>İkiden çok üçgenin buluştuğu yerde kes</translation>
    </message>
    <message>
        <source>Cut where neighbours disagree</source>
        <translation>Komşuların anlaşamadığı yerde kes</translation>
    </message>
    <message>
        <source>Clean up</source>
        <translation>Temizle</translation>
    </message>
    <message>
        <source>Stitch borders</source>
        <translation>Sınırları dik</translation>
    </message>
    <message>
        <source>Drop small pieces</source>
        <translation>Küçük parçaları at</translation>
    </message>
    <message>
        <source>Drop pieces that are counted twice</source>
        <translation>İki kez sayılan parçaları at</translation>
    </message>
    <message>
        <source>Remove crossings</source>
        <translation>Kesişmeleri gider</translation>
    </message>
    <message>
        <source>Wrap</source>
        <translation>Sar</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>Hepsini onar</translation>
    </message>
    <message>
        <source>Drop fins</source>
        <translation>Yüzgeçleri at</translation>
    </message>
    <message>
        <source>Keep what is seen from outside</source>
        <translation>Dışarıdan görüneni tut</translation>
    </message>
    <message>
        <source>Close for filling</source>
        <translation>Doldurmak için kapat</translation>
    </message>
</context>
<context>
    <name>phrases</name>
    <message>
        <source>Add a step</source>
        <translation>Adım ekle</translation>
    </message>
    <message>
        <source>Begin a scenario</source>
        <translation>Senaryoya başla</translation>
    </message>
    <message>
        <source>Change an instrument</source>
        <translation>Bir aleti değiştir</translation>
    </message>
    <message>
        <source>Change a step</source>
        <translation>Adımı değiştir</translation>
    </message>
    <message>
        <source>Change a text</source>
        <translation>Metni değiştir</translation>
    </message>
    <message>
        <source>Change the limits</source>
        <translation>Sınırları değiştir</translation>
    </message>
    <message>
        <source>Change the time limit</source>
        <translation>Süre sınırını değiştir</translation>
    </message>
    <message>
        <source>Draw a place</source>
        <translation>Yer çiz</translation>
    </message>
    <message>
        <source>Duplicate a step</source>
        <translation>Adımı çoğalt</translation>
    </message>
    <message>
        <source>Mute a step</source>
        <translation>Adımı sustur</translation>
    </message>
    <message>
        <source>Order the steps</source>
        <translation>Adımları sırala</translation>
    </message>
    <message>
        <source>Record a step from a hand</source>
        <translation>Adımı elden kaydet</translation>
    </message>
    <message>
        <source>Remove a step</source>
        <translation>Adımı kaldır</translation>
    </message>
    <message>
        <source>The scenario does not say palpate_scenario.</source>
        <translation>Senaryo palpate_scenario demiyor.</translation>
    </message>
    <message>
        <source>The scenario has more than {most} bytes.</source>
        <translation>Senaryo {most} bayttan büyük.</translation>
    </message>
    <message>
        <source>The scenario is not JSON that a file can keep.</source>
        <translation>Senaryo, bir dosyanın tutabileceği bir JSON değil.</translation>
    </message>
    <message>
        <source>There is no scenario to take away.</source>
        <translation>Kaldırılacak bir senaryo yok.</translation>
    </message>
    <message>
        <source>a task that can be done and judged</source>
        <translation>yapılabilen ve değerlendirilebilen bir görev</translation>
    </message>
    <message>
        <source>{where}: {text}</source>
        <translation>{where}: {text}</translation>
    </message>
    <message>
        <source>0 Hz: the tissue ticks with the hand where it can</source>
        <translation>0 Hz: yetişebildiği yerde doku elle birlikte adımlar</translation>
    </message>
    <message>
        <source>at most {share:.0%}</source>
        <translation>en fazla {share:.0%}</translation>
    </message>
    <message>
        <source>felt by its local stiffness, told {rate:g} times a second, though the tissue itself takes about {share:.0%} of a tick</source>
        <translation>yerel katılığıyla hissediliyor, saniyede {rate:g} kez bildiriliyor; oysa dokunun kendisi bir adımın yaklaşık {share:.0%} kadarını alıyor</translation>
    </message>
    <message>
        <source>in a thread of its own the tissue takes about {share:.0%} of the time there is: it would be late, and be felt as nothing where it is later than three exchanges</source>
        <translation>doku kendi iş parçacığında eldeki sürenin yaklaşık {share:.0%} kadarını alıyor: gecikir ve üç alışverişten fazla geciktiği yerde hiç hissedilmez</translation>
    </message>
    <message>
        <source>{count} tetrahedra of the file, which are not used</source>
        <translation>dosyanın kullanılmayan {count} dörtyüzlüsü</translation>
    </message>
    <message>
        <source>the surface as it was read, {count} tetrahedra, and no finer region</source>
        <translation>okunduğu gibi yüzey, {count} dörtyüzlü ve daha ince bölge olmaması</translation>
    </message>
    <message>
        <source>The pieces cannot be united: {problem}.</source>
        <translation>Parçalar birleştirilemiyor: {problem}.</translation>
    </message>
    <message>
        <source>A factor of stiffness must lie between {least:g} and {most:g}, got {got:g}.</source>
        <translation>Katılık çarpanı {least:g} ile {most:g} arasında olmalı; verilen {got:g}.</translation>
    </message>
    <message>
        <source>A region needs a name.</source>
        <translation>Bölgenin bir adı olmalı.</translation>
    </message>
    <message>
        <source>A surface with holes has no outside to turn to.</source>
        <translation>Delikli bir yüzeyin dönülecek dışı yoktur.</translation>
    </message>
    <message>
        <source>An organ has at most {most} regions.</source>
        <translation>Bir organda en çok {most} bölge olur.</translation>
    </message>
    <message>
        <source>Gravity is three finite numbers.</source>
        <translation>Yerçekimi üç sonlu sayıdır.</translation>
    </message>
    <message>
        <source>No vertices are selected.</source>
        <translation>Seçili köşe yok.</translation>
    </message>
    <message>
        <source>None of them is fixed.</source>
        <translation>Hiçbiri sabit değil.</translation>
    </message>
    <message>
        <source>Region {name} has no vertices.</source>
        <translation>{name} bölgesinde köşe yok.</translation>
    </message>
    <message>
        <source>The axis must be one of {known}, got {got}.</source>
        <translation>Eksen şunlardan biri olmalı: {known}; verilen {got}.</translation>
    </message>
    <message>
        <source>The imported surface is in use already.</source>
        <translation>İçe aktarılan yüzey zaten kullanılıyor.</translation>
    </message>
    <message>
        <source>The organ has changed since it was decimated: decimate it again.</source>
        <translation>Organ sadeleştirildiğinden beri değişti: yeniden sadeleştirin.</translation>
    </message>
    <message>
        <source>The share of the height must be more than 0 and at most 1, got {got:g}.</source>
        <translation>Yükseklik payı 0'dan büyük ve en çok 1 olmalı; verilen {got:g}.</translation>
    </message>
    <message>
        <source>The surface is one piece already.</source>
        <translation>Yüzey zaten tek parça.</translation>
    </message>
    <message>
        <source>The triangles face outwards already.</source>
        <translation>Üçgenler zaten dışa bakıyor.</translation>
    </message>
    <message>
        <source>The unit must be one of {known}, got {got}.</source>
        <translation>Birim şunlardan biri olmalı: {known}; verilen {got}.</translation>
    </message>
    <message>
        <source>There is no number {name}.</source>
        <translation>{name} diye bir sayı yok.</translation>
    </message>
    <message>
        <source>There is no organ yet: import a mesh file first.</source>
        <translation>Henüz organ yok: önce bir ağ dosyası içe aktarın.</translation>
    </message>
    <message>
        <source>There is no region {name}.</source>
        <translation>{name} adlı bölge yok.</translation>
    </message>
    <message>
        <source>They are fixed already.</source>
        <translation>Zaten sabitler.</translation>
    </message>
    <message>
        <source>They have this stiffness already.</source>
        <translation>Zaten bu katılıktalar.</translation>
    </message>
    <message>
        <source>This organ was not read from a file.</source>
        <translation>Bu organ bir dosyadan okunmadı.</translation>
    </message>
    <message>
        <source>Vertex numbers: got {low} to {high}, expected 0 to {most}.</source>
        <translation>Köşe numaraları: {low}–{high} verildi, 0–{most} bekleniyordu.</translation>
    </message>
    <message>
        <source>Vertices are chosen by whole numbers.</source>
        <translation>Köşeler tam sayılarla seçilir.</translation>
    </message>
    <message>
        <source>a closed surface, or a hollow organ or sheet that has them</source>
        <translation>kapalı bir yüzey ya da delikleri olan içi boş bir organ veya zar</translation>
    </message>
    <message>
        <source>a closed surface, or the thickness of its wall</source>
        <translation>kapalı bir yüzey ya da duvar kalınlığı</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>bir ağ dosyası</translation>
    </message>
    <message>
        <source>a smallest angle of {angle:.1f} degrees</source>
        <translation>en küçük açı {angle:.1f} derece</translation>
    </message>
    <message>
        <source>a solid with holes</source>
        <translation>delikleri olan dolu bir cisim</translation>
    </message>
    <message>
        <source>a surface that does not cross itself</source>
        <translation>kendisiyle kesişmeyen bir yüzey</translation>
    </message>
    <message>
        <source>a test, so that you know what the trainee will feel</source>
        <translation>eğitim görenin ne hissedeceğini bilmeniz için bir deneme</translation>
    </message>
    <message>
        <source>a unit that you have confirmed</source>
        <translation>onayladığınız bir birim</translation>
    </message>
    <message>
        <source>a whole number of {low:g} to {high:g}</source>
        <translation>{low:g} ile {high:g} arasında bir tam sayı</translation>
    </message>
    <message>
        <source>an axis that you have confirmed</source>
        <translation>onayladığınız bir eksen</translation>
    </message>
    <message>
        <source>an organ of {size:.4g} mm from corner to corner</source>
        <translation>köşeden köşeye {size:.4g} mm bir organ</translation>
    </message>
    <message>
        <source>any finite number</source>
        <translation>herhangi bir sonlu sayı</translation>
    </message>
    <message>
        <source>at least half the mean edge of {edge:.1f} mm</source>
        <translation>en az {edge:.1f} mm olan ortalama kenarın yarısı</translation>
    </message>
    <message>
        <source>at least {low:g}{unit}</source>
        <translation>en az {low:g}{unit}</translation>
    </message>
    <message>
        <source>at most {most}: decimate</source>
        <translation>en çok {most}: sadeleştirin</translation>
    </message>
    <message>
        <source>at most {share:.0%}: fewer tetrahedra, or a softer tissue</source>
        <translation>en çok {share:.0%}: daha az dörtyüzlü ya da daha yumuşak doku</translation>
    </message>
    <message>
        <source>at most {share:.0%}: fewer vertices, softer links or more mass</source>
        <translation>en çok {share:.0%}: daha az köşe, daha yumuşak bağlantılar ya da daha çok kütle</translation>
    </message>
    <message>
        <source>every vertex fixed</source>
        <translation>her köşe sabit</translation>
    </message>
    <message>
        <source>more than {low:g}, at most {high:g}{unit}</source>
        <translation>{low:g} değerinden büyük, en çok {high:g}{unit}</translation>
    </message>
    <message>
        <source>more than {low:g}{unit}</source>
        <translation>{low:g}{unit} değerinden büyük</translation>
    </message>
    <message>
        <source>for presses of up to {share:.0%} of the thickness alone, and {least:.0f} to {most:.0f} % too stiff under a small patch</source>
        <translation>yalnızca kalınlığın {share:.0%} kadarına varan basışlar için; küçük bir yama altında %{least:.0f} ile %{most:.0f} arasında fazla sert</translation>
    </message>
    <message>
        <source>a surface by itself has {solid_least:.0f} to {solid_most:.0f} % of a solid organ's force and {wall_least:.0f} to {wall_most:.0f} % of a hollow one's, unless home springs or constants are chosen to hold it up</source>
        <translation>tek başına bir yüzey, onu ayakta tutacak yuva yayları ya da sabitler seçilmedikçe, dolu bir organın kuvvetinin %{solid_least:.0f} ile %{solid_most:.0f} arasını, içi boş bir organınkinin %{wall_least:.0f} ile %{wall_most:.0f} arasını verir</translation>
    </message>
    <message>
        <source>not yet among the kinds that the accuracy study holds against finite elements, and {times:.0f} times the time of springs and volumes</source>
        <translation>doğruluk çalışmasının sonlu elemanlarla karşılaştırdığı türler arasında henüz yok; süresi yay ve hacimlerinkinin {times:.0f} katı</translation>
    </message>
    <message>
        <source>neither home springs nor fixed vertices</source>
        <translation>ne yuva yayı ne de sabit köşe</translation>
    </message>
    <message>
        <source>never felt as it is now</source>
        <translation>şimdiki hâliyle hiç hissedilmedi</translation>
    </message>
    <message>
        <source>no surface</source>
        <translation>yüzey yok</translation>
    </message>
    <message>
        <source>no task</source>
        <translation>görev yok</translation>
    </message>
    <message>
        <source>no title</source>
        <translation>başlık yok</translation>
    </message>
    <message>
        <source>none</source>
        <translation>hiç</translation>
    </message>
    <message>
        <source>one of {allowed}</source>
        <translation>şunlardan biri: {allowed}</translation>
    </message>
    <message>
        <source>one piece</source>
        <translation>tek parça</translation>
    </message>
    <message>
        <source>outwards</source>
        <translation>dışa</translation>
    </message>
    <message>
        <source>so many triangles on top of each other that counting was given up</source>
        <translation>üst üste öyle çok üçgen var ki saymaktan vazgeçildi</translation>
    </message>
    <message>
        <source>some that can move</source>
        <translation>hareket edebilen birkaç köşe</translation>
    </message>
    <message>
        <source>something that holds the organ in its place</source>
        <translation>organı yerinde tutan bir şey</translation>
    </message>
    <message>
        <source>triangles that face inwards</source>
        <translation>içe bakan üçgenler</translation>
    </message>
    <message>
        <source>what the trainee chooses it by</source>
        <translation>eğitim görenin onu seçeceği ad</translation>
    </message>
    <message>
        <source>what the trainee is asked to do</source>
        <translation>eğitim görenden ne istendiği</translation>
    </message>
    <message>
        <source>{count} edges with more than two triangles</source>
        <translation>ikiden çok üçgenli {count} kenar</translation>
    </message>
    <message>
        <source>Factors: got {count}, expected {ids}, one for each vertex.</source>
        <translation>Çarpanlar: {count} verildi, her köşeye bir tane, {ids} bekleniyordu.</translation>
    </message>
    <message>
        <source>{count} pieces that nothing holds together</source>
        <translation>hiçbir şeyin bir arada tutmadığı {count} parça</translation>
    </message>
    <message>
        <source>{count} triangles that cross others</source>
        <translation>başkalarıyla kesişen {count} üçgen</translation>
    </message>
    <message>
        <source>{count} vertices</source>
        <translation>{count} köşe</translation>
    </message>
    <message>
        <source>{field} must be one of {allowed}, got {got}.</source>
        <translation>{field} şunlardan biri olmalı: {allowed}; verilen {got}.</translation>
    </message>
    <message>
        <source>{label} must be {range}, got {got}.</source>
        <translation>{label}: olması gereken {range}; verilen {got}.</translation>
    </message>
    <message>
        <source>{least:g} to {most:g} mm</source>
        <translation>{least:g}–{most:g} mm</translation>
    </message>
    <message>
        <source>{low:g} to {high:g}{unit}</source>
        <translation>{low:g}–{high:g}{unit}</translation>
    </message>
    <message>
        <source>{radius:.1f} mm</source>
        <translation>{radius:.1f} mm</translation>
    </message>
    <message>
        <source>{unit}, guessed ({why})</source>
        <translation>{unit}, tahmin ({why})</translation>
    </message>
    <message>
        <source>{up}, guessed ({why})</source>
        <translation>{up}, tahmin ({why})</translation>
    </message>
    <message>
        <source>{value}</source>
        <translation>{value}</translation>
    </message>
    <message>
        <source>It cannot be decimated to {vertices} vertices: {why}</source>
        <translation>{vertices} köşeye indirilemiyor: {why}</translation>
    </message>
    <message>
        <source>{what}: letters that cannot be written.</source>
        <translation>{what}: yazılamayan harfler.</translation>
    </message>
    <message>
        <source>{what}: got {count} bytes of text, expected at most {most}.</source>
        <translation>{what}: {count} baytlık metin verildi, en çok {most} bekleniyordu.</translation>
    </message>
    <message>
        <source>{text}</source>
        <translation>{text}</translation>
    </message>
    <message>
        <source>The style must be one of {known}, got {got}.</source>
        <translation>Görünüm şunlardan biri olmalı: {known}; verilen {got}.</translation>
    </message>
    <message>
        <source>A colour is three numbers of 0 to 1, got {got}.</source>
        <translation>Renk, 0 ile 1 arasında üç sayıdır; verilen {got}.</translation>
    </message>
    <message>
        <source>a hole of {edges} edges</source>
        <translation>{edges} kenarlı bir delik</translation>
    </message>
    <message>
        <source>{count} holes of {edges} edges each</source>
        <translation>her biri {edges} kenarlı {count} delik</translation>
    </message>
    <message>
        <source>{count} holes of {least} to {most} edges</source>
        <translation>{least} ile {most} arası kenarlı {count} delik</translation>
    </message>
    <message>
        <source>There is no hole to fill.</source>
        <translation>Doldurulacak delik yok.</translation>
    </message>
    <message>
        <source>No patch fits: a hole touches another one, is too large, or would be closed through the surface.</source>
        <translation>Uyan yama yok: bir delik başka birine değiyor, çok büyük ya da yama yüzeyin içinden geçiyor.</translation>
    </message>
    <message>
        <source>Hole: got {got}, expected 0 to {most}.</source>
        <translation>Delik: {got} verildi, 0–{most} bekleniyordu.</translation>
    </message>
    <message>
        <source>A published value needs its source.</source>
        <translation>Yayımlanmış bir değerin kaynağı gerekir.</translation>
    </message>
    <message>
        <source>A scenario has at most {most} further languages.</source>
        <translation>Bir senaryonun en çok {most} başka dili olabilir.</translation>
    </message>
    <message>
        <source>Axis that points up: {up}</source>
        <translation>Yukarı bakan eksen: {up}</translation>
    </message>
    <message>
        <source>Decimate to {count} vertices</source>
        <translation>{count} köşeye sadeleştir</translation>
    </message>
    <message>
        <source>Fix the lowest {share:g} %</source>
        <translation>En alttaki % {share:g} kısmı sabitle</translation>
    </message>
    <message>
        <source>Fix {count} vertices</source>
        <translation>{count} köşeyi sabitle</translation>
    </message>
    <message>
        <source>Free {count} vertices</source>
        <translation>{count} köşeyi serbest bırak</translation>
    </message>
    <message>
        <source>Gravity: {x:g}, {y:g}, {z:g} m/s²</source>
        <translation>Yerçekimi: {x:g}; {y:g}; {z:g} m/s²</translation>
    </message>
    <message>
        <source>No gravity</source>
        <translation>Yerçekimi yok</translation>
    </message>
    <message>
        <source>Material of {tissue}</source>
        <translation>Malzeme: {tissue}</translation>
    </message>
    <message>
        <source>Name the organ: {name}</source>
        <translation>Organın adı: {name}</translation>
    </message>
    <message>
        <source>Paint stiffness</source>
        <translation>Katılık boya</translation>
    </message>
    <message>
        <source>Paste a material: {kind}, {value}</source>
        <translation>Malzeme yapıştır: {kind}, {value}</translation>
    </message>
    <message>
        <source>Reach: all of the surface</source>
        <translation>Erişim: yüzeyin tümü</translation>
    </message>
    <message>
        <source>Reach: {region}</source>
        <translation>Erişim: {region}</translation>
    </message>
    <message>
        <source>Region {name}: {count} vertices</source>
        <translation>Bölge {name}: {count} köşe</translation>
    </message>
    <message>
        <source>Remove region {name}</source>
        <translation>{name} bölgesini kaldır</translation>
    </message>
    <message>
        <source>Set a number</source>
        <translation>Bir sayı ayarla</translation>
    </message>
    <message>
        <source>Set the task</source>
        <translation>Görevi ayarla</translation>
    </message>
    <message>
        <source>Set title and task</source>
        <translation>Başlık ve görevi ayarla</translation>
    </message>
    <message>
        <source>Stiffness of {count} vertices: {low:.3g} to {high:.3g} ×</source>
        <translation>{count} köşenin katılığı: {low:.3g} – {high:.3g} ×</translation>
    </message>
    <message>
        <source>Stiffness of {count} vertices: {low:.3g} ×</source>
        <translation>{count} köşenin katılığı: {low:.3g} ×</translation>
    </message>
    <message>
        <source>The language must be a code such as tr or pt-BR, got {got}.</source>
        <translation>Dil tr ya da pt-BR gibi bir kod olmalı; verilen: {got}.</translation>
    </message>
    <message>
        <source>The range begins at {low} and ends at {high}: turn it round.</source>
        <translation>Aralık {low} ile başlayıp {high} ile bitiyor: ters çevirin.</translation>
    </message>
    <message>
        <source>Title: {title}</source>
        <translation>Başlık: {title}</translation>
    </message>
    <message>
        <source>Unit of the file: {unit}</source>
        <translation>Dosyanın birimi: {unit}</translation>
    </message>
    <message>
        <source>Got {count} letters, expected at most {most}.</source>
        <translation>{count} harf verildi, en çok {most} bekleniyordu.</translation>
    </message>
    <message>
        <source>{name}: {value}</source>
        <translation>{name}: {value}</translation>
    </message>
    <message>
        <source>{value:g}</source>
        <translation>{value:g}</translation>
    </message>
    <message>
        <source>{value:g} {unit}</source>
        <translation>{value:g} {unit}</translation>
    </message>
    <message>
        <source>springs and bonds take the stiffness that is chosen</source>
        <translation>yaylar ve bağlar seçilen katılığı alır</translation>
    </message>
    <message>
        <source>springs, bonds and home springs take the stiffness that is chosen</source>
        <translation>yaylar, bağlar ve yuva yayları seçilen katılığı alır</translation>
    </message>
    <message>
        <source>{made}, {share:.0%} fewer than the {asked} that were asked for</source>
        <translation>{made}; istenen {asked} sayısından {share:.0%} az</translation>
    </message>
    <message>
        <source>{made}, {share:.0%} more than the {asked} that were asked for</source>
        <translation>{made}; istenen {asked} sayısından {share:.0%} çok</translation>
    </message>
    <message>
        <source>about {like:.2f}, or the molecular model, which can have any</source>
        <translation>yaklaşık {like:.2f} ya da her değeri alabilen moleküler model</translation>
    </message>
    <message>
        <source>at most {most:.0%}: else a foundation of springs is felt, which Young's modulus does not set; a solid has none, nor has a wall that bends</source>
        <translation>en çok {most:.0%}: yoksa duyulan, Young modülünün belirlemediği bir yay yatağıdır; dolu cisimde ve bükülen duvarda böyle yay yoktur</translation>
    </message>
    <message>
        <source>at most {most:g} m/s², turned to where the organ lies</source>
        <translation>en çok {most:g} m/s², organın yatışına göre döndürülmüş</translation>
    </message>
    <message>
        <source>{rate:g} Hz, of which a tick has {count} steps, of {step:.2g} us at most</source>
        <translation>{rate:g} Hz; bir adımda {count} alt adım var, her biri en çok {step:.2g} us</translation>
    </message>
    <message>
        <source>at least {least:g} Hz; a hand is asked at {usual:g} Hz</source>
        <translation>en az {least:g} Hz; ele {usual:g} Hz ile sorulur</translation>
    </message>
    <message>
        <source>at most {most}: a softer or heavier tissue, less damping or larger triangles</source>
        <translation>en çok {most}: daha yumuşak ya da daha ağır bir doku, daha az sönüm ya da daha büyük üçgenler</translation>
    </message>
    <message>
        <source>contact as on tissue, which is felt alike on any mesh; or edges of at most {edge:.1f} mm for {times:g} times: more tetrahedra or a larger tip</source>
        <translation>her ağda aynı hissedilen, dokudaki gibi temas; ya da {times:g} kat için en çok {edge:.1f} mm kenar: daha çok dörtyüzlü ya da daha büyük bir uç</translation>
    </message>
    <message>
        <source>edges of {low:.1f} to {high:.1f} mm at the surface under a contact radius of {contact:.1f} mm (a tip of {radius:g} mm pressed {depth:g} mm): by place the force is about {least:.1f} to {most:.1f} times that of the tissue</source>
        <translation>{contact:.1f} mm temas yarıçapı altında ({depth:g} mm bastırılan {radius:g} mm uç) yüzeydeki kenarlar {low:.1f} ile {high:.1f} mm arasında: kuvvet yerine göre dokununkinin yaklaşık {least:.1f} ile {most:.1f} katı</translation>
    </message>
    <message>
        <source>home springs of 0 N/m in all: a surface of springs has no stiffness across itself and caves in under the tip</source>
        <translation>yuva yayları toplam 0 N/m: yaylardan bir yüzeyin kendine dik katılığı yoktur, ucun altında çöker</translation>
    </message>
    <message>
        <source>home springs, a pressure inside, a wall that bends, or a solid</source>
        <translation>yuva yayları, içeride bir basınç, bükülen bir duvar ya da dolu bir cisim</translation>
    </message>
    <message>
        <source>{count} steps a tick, of {step:.2g} us at most</source>
        <translation>adım başına {count} alt adım, her biri en çok {step:.2g} us</translation>
    </message>
    <message>
        <source>{count} vertices, {substeps} steps a tick in touch: about {share:.0%} of the time there is</source>
        <translation>{count} köşe, temasta adım başına {substeps} alt adım: eldeki zamanın yaklaşık {share:.0%} kadarı</translation>
    </message>
    <message>
        <source>{substeps} steps a tick in touch: about {share:.0%} of the time there is</source>
        <translation>temasta adım başına {substeps} alt adım: eldeki zamanın yaklaşık {share:.0%} kadarı</translation>
    </message>
    <message>
        <source>at most {most:.0%}: a coarser or softer organ, or published as slow</source>
        <translation>en çok {most:.0%}: daha kaba ya da yumuşak bir organ; ya da yavaş olarak yayımlanması</translation>
    </message>
    <message>
        <source>at most {most:.0%}: a coarser or softer organ, an exchange rate, or published as slow</source>
        <translation>en çok {most:.0%}: daha kaba ya da yumuşak bir organ, bir alışveriş hızı; ya da yavaş olarak yayımlanması</translation>
    </message>
    <message>
        <source>at most {most:.0%}: a coarser organ, {name}: {limit}, an exchange rate, or published as slow</source>
        <translation>en çok {most:.0%}: daha kaba bir organ, {name}: {limit}, bir alışveriş hızı; ya da yavaş olarak yayımlanması</translation>
    </message>
    <message>
        <source>{count}, {substeps} steps a tick in touch: about {share:.0%} of the time there is</source>
        <translation>{count}, temasta adım başına {substeps} alt adım: eldeki zamanın yaklaşık {share:.0%} kadarı</translation>
    </message>
    <message>
        <source>{least:.0%} to {most:.0%} of the felt force through home springs, by place ({count} pressed {depth:g} mm)</source>
        <translation>duyulan kuvvetin {least:.0%} ile {most:.0%} arası, yerine göre, yuva yaylarından gelir ({depth:g} mm bastırılan {count} yer)</translation>
    </message>
    <message>
        <source>{nu:g}, but springs stretch like {like:.2f}: {least:.2f} to {most:.2f} times as stiff as the wall, by direction and place</source>
        <translation>{nu:g}, oysa yaylar {like:.2f} gibi gerilir: yöne ve yere göre duvarın {least:.2f} ile {most:.2f} katı kadar katı</translation>
    </message>
    <message>
        <source>{size:.4g} m/s², {times:.3g} times that of the Earth: {mass:.4g} g of tissue weigh {weight:.3g} N</source>
        <translation>{size:.4g} m/s², Dünya ivmesinin {times:.3g} katı: {mass:.4g} g doku {weight:.3g} N ağırlığındadır</translation>
    </message>
    <message>
        <source>{share:g} with a Poisson's ratio of {nu:g}: single tetrahedra that hardly change their volume lock, and the force is up to {times:g} times that at {usual:g}</source>
        <translation>{nu:g} Poisson oranıyla {share:g}: hacmini neredeyse değiştirmeyen tek tek dörtyüzlüler kilitlenir ve kuvvet {usual:g} değerindekinin {times:g} katına kadar çıkar</translation>
    </message>
    <message>
        <source>a nodal share of about {usual:g}</source>
        <translation>yaklaşık {usual:g} düğüm payı</translation>
    </message>
    <message>
        <source>It counts in a solid, and where the tissue gives a wall its constants.</source>
        <translation>Dolu bir cisimde ve duvarın sabitlerini doku verdiğinde hesaba katılır.</translation>
    </message>
    <message>
        <source>a relaxation of 0 has no time</source>
        <translation>0 olan bir gevşemenin süresi yoktur</translation>
    </message>
    <message>
        <source>It counts where the relaxation is above 0.</source>
        <translation>Gevşeme 0'dan büyük olduğunda hesaba katılır.</translation>
    </message>
    <message>
        <source>{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are validated: a tenth of the thickness of {length:.1f} mm</source>
        <translation>{x}, {y}, {z} mm yerinde {depth:.1f} mm derin; orada {validated:.1f} mm doğrulanmıştır: {length:.1f} mm kalınlığın onda biri</translation>
    </message>
    <message>
        <source>{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are validated: the thickness of its wall, {length:.1f} mm</source>
        <translation>{x}, {y}, {z} mm yerinde {depth:.1f} mm derin; orada {validated:.1f} mm doğrulanmıştır: duvarın kalınlığı, {length:.1f} mm</translation>
    </message>
    <message>
        <source>{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are validated: one and a half times the tip's radius of {length:.1f} mm</source>
        <translation>{x}, {y}, {z} mm yerinde {depth:.1f} mm derin; orada {validated:.1f} mm doğrulanmıştır: ucun {length:.1f} mm yarıçapının bir buçuk katı</translation>
    </message>
    <message>
        <source>a press of {depth:.1f} mm with a tip of {radius:g} mm, for which no depth is validated</source>
        <translation>{radius:g} mm uçla {depth:.1f} mm basış; bu uç için hiçbir derinlik doğrulanmamıştır</translation>
    </message>
    <message>
        <source>a ball of {least:g} to {most:g} mm, as those that forces were compared with</source>
        <translation>{least:g} ile {most:g} mm arası bir küre: kuvvetlerin karşılaştırıldığı küreler gibi</translation>
    </message>
    <message>
        <source>at most {validated:.1f} mm, or a tip of {radius:.1f} mm: deeper no truth was solved to compare the force with</source>
        <translation>en çok {validated:.1f} mm ya da {radius:.1f} mm bir uç: daha derini için kuvvetin karşılaştırılacağı bir çözüm yoktur</translation>
    </message>
    <message>
        <source>at most {validated:.1f} mm: deeper no truth was solved to compare the force with</source>
        <translation>en çok {validated:.1f} mm: daha derini için kuvvetin karşılaştırılacağı bir çözüm yoktur</translation>
    </message>
    <message>
        <source>Configuration: {kind}, {step}</source>
        <translation>Yapılandırma: {kind}, {step}</translation>
    </message>
    <message>
        <source>The organ has that configuration already.</source>
        <translation>Organ zaten bu yapılandırmada.</translation>
    </message>
    <message>
        <source>{step}</source>
        <translation>{step}</translation>
    </message>
    <message>
        <source>{kind}</source>
        <translation>{kind}</translation>
    </message>
    <message>
        <source>{first}, {rest}</source>
        <translation>{first}, {rest}</translation>
    </message>
    <message>
        <source>1 substep</source>
        <translation>1 alt adım</translation>
    </message>
    <message>
        <source>{count} substeps</source>
        <translation>{count} alt adım</translation>
    </message>
    <message>
        <source>contact as on the mesh</source>
        <translation>temas ağdaki gibi</translation>
    </message>
    <message>
        <source>contact as on tissue</source>
        <translation>temas dokudaki gibi</translation>
    </message>
    <message>
        <source>{count} tetrahedra</source>
        <translation>{count} dörtyüzlü</translation>
    </message>
    <message>
        <source>chosen constants</source>
        <translation>elle seçilmiş sabitler</translation>
    </message>
    <message>
        <source>chosen by hand: {stiffness:g} N/m, home springs by kind</source>
        <translation>elle seçilmiş: {stiffness:g} N/m, yuva yayları türüne göre</translation>
    </message>
    <message>
        <source>chosen by hand: {stiffness:g} N/m, home springs of {home:g} N/mm³</source>
        <translation>elle seçilmiş: {stiffness:g} N/m, {home:g} N/mm³ yuva yayları</translation>
    </message>
    <message>
        <source>from E {modulus:g} kPa, nu {ratio:g}</source>
        <translation>E {modulus:g} kPa, nu {ratio:g} değerlerinden</translation>
    </message>
    <message>
        <source>from E {modulus:g} kPa, nu {ratio:g}, a wall of {wall:g} mm</source>
        <translation>E {modulus:g} kPa, nu {ratio:g} ve {wall:g} mm duvardan</translation>
    </message>
    <message>
        <source>A tick in touch takes {median:.3g} µs, p99 {p99:.3g} µs, of {period:.4g} µs that it may; {misses:.1%} take longer.</source>
        <translation>Temasta bir adım {median:.3g} µs, p99 {p99:.3g} µs sürer; {period:.4g} µs sürebilir; {misses:.1%} kadarı daha uzun sürer.</translation>
    </message>
    <message>
        <source>An alarm ended it: {why}.</source>
        <translation>Bir alarm bitirdi: {why}.</translation>
    </message>
    <message>
        <source>Force {rms:.1%} off, at most {most:.1%}.</source>
        <translation>Kuvvet {rms:.1%} sapar, en çok {most:.1%}.</translation>
    </message>
    <message>
        <source>Force {rms:.1%} off, at most {most:.1%}; displacement {displacement:.1%}.</source>
        <translation>Kuvvet {rms:.1%} sapar, en çok {most:.1%}; yer değiştirme {displacement:.1%}.</translation>
    </message>
    <message>
        <source>It cannot be built: {why}.</source>
        <translation>Kurulamıyor: {why}.</translation>
    </message>
    <message>
        <source>It was drawn with another value: {label} of {there}, where the organ has {here}.</source>
        <translation>Başka bir değerle çizilmiş: {label} {there}; organda {here}.</translation>
    </message>
    <message>
        <source>Lost: {why}.</source>
        <translation>Yitirildi: {why}.</translation>
    </message>
    <message>
        <source>Not timed yet.</source>
        <translation>Süresi henüz ölçülmedi.</translation>
    </message>
    <message>
        <source>Of that the model itself {model:.1%}, its steps in time {time:.1%}; the truth is known to {truth:.1%}.</source>
        <translation>Bunun {model:.1%} kadarı modelin kendisinden, {time:.1%} kadarı zaman adımlarından; gerçek {truth:.1%} ile bilinir.</translation>
    </message>
    <message>
        <source>That is no more than the truth's own error: which of such rows is better it cannot tell.</source>
        <translation>Bu, gerçeğin kendi hatasından fazla değildir: böyle satırlardan hangisinin daha iyi olduğunu söyleyemez.</translation>
    </message>
    <message>
        <source>The truth is known to {truth:.1%}.</source>
        <translation>Gerçek {truth:.1%} ile bilinir.</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>sürükleme</translation>
    </message>
    <message>
        <source>press</source>
        <translation>basma</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>çekme</translation>
    </message>
    <message>
        <source>script</source>
        <translation>betik</translation>
    </message>
    <message>
        <source>{organ}: a {way} of {depth:.2g} mm with a ball of {radius:.2g} mm; {ran} of {all} configurations ran to the end.</source>
        <translation>{organ}: {radius:.2g} mm topla {depth:.2g} mm {way}; {all} yapılandırmadan {ran} tanesi sonuna kadar gitti.</translation>
    </message>
    <message>
        <source>{particles} particles, {elements} elements; at most {substeps} substeps in touch.</source>
        <translation>{particles} parçacık, {elements} öğe; temasta en çok {substeps} alt adım.</translation>
    </message>
    <message>
        <source>All neighbours agree on which side is outside.</source>
        <translation>Bütün komşular hangi yanın dışarısı olduğunda anlaşıyor.</translation>
    </message>
    <message>
        <source>It cannot be decimated before its surface is repaired: see its problems.</source>
        <translation>Onarım yüzeyini onarmadan sadeleştirilemez: sorunlarına bakın.</translation>
    </message>
    <message>
        <source>No edge has more than two triangles.</source>
        <translation>Hiçbir kenarda ikiden çok üçgen yok.</translation>
    </message>
    <message>
        <source>Nothing of the surface would be left.</source>
        <translation>Yüzeyden geriye bir şey kalmazdı.</translation>
    </message>
    <message>
        <source>a surface that no tissue can be built on yet</source>
        <translation>üzerine henüz doku kurulamayan bir yüzey</translation>
    </message>
    <message>
        <source>a surface with one side only, like a Moebius band</source>
        <translation>Möbius şeridi gibi tek yanlı bir yüzey</translation>
    </message>
    <message>
        <source>at most two triangles at every edge: cut along those, or choose fewer parts</source>
        <translation>her kenarda en çok iki üçgen: onlar boyunca kesin ya da daha az parça seçin</translation>
    </message>
    <message>
        <source>at most {most:g} %: choose fewer parts, unite them, or keep the largest piece</source>
        <translation>en çok %{most:g}: daha az parça seçin, birleştirin ya da en büyük parçayı tutun</translation>
    </message>
    <message>
        <source>one without the problems that the Repair stage lists</source>
        <translation>sorunlarını Onarım aşamasının giderdiği bir yüzey</translation>
    </message>
    <message>
        <source>one with an inside and an outside: cut where neighbours disagree</source>
        <translation>içi ve dışı olan bir yüzey: komşuların anlaşamadığı yerde kesin</translation>
    </message>
    <message>
        <source>{count} of {all} triangles that cross others, as of parts inside each other</source>
        <translation>iç içe parçalarda olduğu gibi başkalarını kesen {all} üçgenden {count} tanesi</translation>
    </message>
    <message>
        <source>Tissue of {region}: {tissue}</source>
        <translation>{region} dokusu: {tissue}</translation>
    </message>
    <message>
        <source>Tissue: {tissue}</source>
        <translation>Doku: {tissue}</translation>
    </message>
    <message>
        <source>a value that was read in its source, or that you have measured</source>
        <translation>kaynağında okunmuş ya da sizin ölçtüğünüz bir değer</translation>
    </message>
    <message>
        <source>{value} of {tissue}, a value of your own that no publication stands for</source>
        <translation>{tissue} için {value}, arkasında yayın olmayan kendi değeriniz</translation>
    </message>
    <message>
        <source>{value} of {tissue}, recalled and not looked up ({source})</source>
        <translation>{tissue} için {value}, bellekten, kaynağına bakılmadı ({source})</translation>
    </message>
    <message>
        <source>an organ of {size:.4g} mm from corner to corner, whose name says {word}</source>
        <translation>köşeden köşeye {size:.4g} mm’lik, adında {word} geçen bir organ</translation>
    </message>
    <message>
        <source>Accuracy binds: its force is too far off.</source>
        <translation>Doğruluk sınırlıyor: kuvveti çok sapıyor.</translation>
    </message>
    <message>
        <source>Accuracy binds: its shape is too far off.</source>
        <translation>Doğruluk sınırlıyor: biçimi çok sapıyor.</translation>
    </message>
    <message>
        <source>It will be pressed or pulled {depth:.1f} mm: kinds for small displacements are left out, and how right the others are so far was not asked.</source>
        <translation>{depth:.1f} mm basılacak ya da çekilecek: küçük yer değiştirmeler için olan türler dışarıda bırakıldı; ötekilerin o kadar derinde ne kadar doğru olduğu sorulmadı.</translation>
    </message>
    <message>
        <source>Accuracy binds: the force of what is cheaper is further off.</source>
        <translation>Doğruluk sınırlıyor: daha ucuz olanın kuvveti daha çok sapar.</translation>
    </message>
    <message>
        <source>Accuracy binds: the shape of what is cheaper is further off.</source>
        <translation>Doğruluk sınırlıyor: daha ucuz olanın biçimi daha çok sapar.</translation>
    </message>
    <message>
        <source>Displacement {value:.1%} off with the truth's own error, of {allowed:.0%} allowed.</source>
        <translation>Yer değiştirme, gerçeğin kendi hatasıyla {value:.1%} sapar; izin verilen {allowed:.0%}.</translation>
    </message>
    <message>
        <source>Displacement: nobody looked at it, so it meets no target.</source>
        <translation>Yer değiştirme: ona bakılmadı, bu yüzden hiçbir hedefi karşılamaz.</translation>
    </message>
    <message>
        <source>Edges of {edge:.1f} mm are touched.</source>
        <translation>{edge:.1f} mm kenarlara dokunulur.</translation>
    </message>
    <message>
        <source>Force {value:.1%} off with the truth's own error, of {allowed:.0%} allowed.</source>
        <translation>Kuvvet, gerçeğin kendi hatasıyla {value:.1%} sapar; izin verilen {allowed:.0%}.</translation>
    </message>
    <message>
        <source>Its displacement is {held:.1%} off there, {charted:.1%} on the chart.</source>
        <translation>Yer değiştirmesi orada {held:.1%}, çizelgede {charted:.1%} sapar.</translation>
    </message>
    <message>
        <source>Its steps are stable at any length.</source>
        <translation>Adımları her uzunlukta kararlıdır.</translation>
    </message>
    <message>
        <source>Its steps are {value:.2f} of the longest stable one, of {allowed:g} allowed.</source>
        <translation>Adımları en uzun kararlı adımın {value:.2f} katıdır; izin verilen {allowed:g}.</translation>
    </message>
    <message>
        <source>Keep what it has: {name}.</source>
        <translation>Şimdiki kalsın: {name}.</translation>
    </message>
    <message>
        <source>Next better: {name}; {times:.2g} times the cost, with {misses}.</source>
        <translation>Bir sonraki daha iyi: {name}; {times:.2g} kat maliyet, {misses}.</translation>
    </message>
    <message>
        <source>Next cheaper: {name}; {times:.2g} times cheaper, with {misses}.</source>
        <translation>Bir sonraki daha ucuz: {name}; {times:.2g} kat ucuz, {misses}.</translation>
    </message>
    <message>
        <source>No place is left to score it at: all are near what is held, or what was charted.</source>
        <translation>Sınanacak yer kalmadı: hepsi tutulan ya da çizelgelenen yerlere yakın.</translation>
    </message>
    <message>
        <source>None of the {ran} configurations that ran meets every target. Nearest: {name}.</source>
        <translation>Çalışan {ran} yapılandırmanın hiçbiri her hedefi karşılamıyor. En yakını: {name}.</translation>
    </message>
    <message>
        <source>None of {tried} configurations came to the end of the path, so there is nothing to choose from.</source>
        <translation>{tried} yapılandırmadan hiçbiri yolun sonuna varmadı; seçilecek bir şey yok.</translation>
    </message>
    <message>
        <source>Not scored: an alarm ended a held-out press ({why}).</source>
        <translation>Sınanamadı: ayrı tutulan bir basmayı bir alarm bitirdi ({why}).</translation>
    </message>
    <message>
        <source>Nothing binds: no other configuration is cheaper for certain.</source>
        <translation>Sınırlayan yok: başka hiçbir yapılandırma kesin olarak daha ucuz değil.</translation>
    </message>
    <message>
        <source>Nothing on the chart is better by more than the truth's own error.</source>
        <translation>Çizelgedeki hiçbir şey gerçeğin kendi hatasından daha çok iyi değil.</translation>
    </message>
    <message>
        <source>On {count} presses held out from the choice its force is {held:.1%} off, where the chart has {charted:.1%}; the truth is known to {truth:.1%} there, to {own:.1%} on the chart.</source>
        <translation>Seçimden ayrı tutulan {count} basmada kuvveti {held:.1%} sapar, çizelgede {charted:.1%}; gerçek orada {truth:.1%}, çizelgede {own:.1%} ile bilinir.</translation>
    </message>
    <message>
        <source>Stability binds: its steps are too long.</source>
        <translation>Kararlılık sınırlıyor: adımları çok uzun.</translation>
    </message>
    <message>
        <source>Stability binds: what is cheaper steps too near its limit.</source>
        <translation>Kararlılık sınırlıyor: daha ucuz olan sınırına çok yakın adım atıyor.</translation>
    </message>
    <message>
        <source>The cheapest that meets every target: {name}.</source>
        <translation>Her hedefi karşılayan en ucuzu: {name}.</translation>
    </message>
    <message>
        <source>The truth binds: by itself it would do, but the truth leaves more open than the target.</source>
        <translation>Gerçek sınırlıyor: kendi başına yeterdi, ama gerçek hedeften çoğunu açık bırakıyor.</translation>
    </message>
    <message>
        <source>The truth binds: something cheaper would do, but for what the truth itself leaves open.</source>
        <translation>Gerçek sınırlıyor: gerçeğin açık bıraktığı olmasa daha ucuzu yeterdi.</translation>
    </message>
    <message>
        <source>There the ball touches a circle of {contact:.1f} mm radius, on edges of {edge:.1f} mm: {across:.1f} of them across it.</source>
        <translation>Orada top {contact:.1f} mm yarıçaplı bir daireye dokunur; kenarlar {edge:.1f} mm: daireye {across:.1f} tanesi sığar.</translation>
    </message>
    <message>
        <source>Time binds: its ticks in touch take too long.</source>
        <translation>Zaman sınırlıyor: temastaki adımları çok uzun sürer.</translation>
    </message>
    <message>
        <source>Time binds: what is cheaper on average has longer ticks among them.</source>
        <translation>Zaman sınırlıyor: ortalamada daha ucuz olanın aralarında daha uzun adımlar var.</translation>
    </message>
    <message>
        <source>Validated to {depth:.1f} mm deep, a tenth of the thickness of {thickness:.0f} mm.</source>
        <translation>{depth:.1f} mm derine kadar doğrulandı: {thickness:.0f} mm kalınlığın onda biri.</translation>
    </message>
    <message>
        <source>Validated to {depth:.1f} mm deep, one and a half times the tip's radius of {radius:g} mm.</source>
        <translation>{depth:.1f} mm derine kadar doğrulandı: {radius:g} mm uç yarıçapının bir buçuk katı.</translation>
    </message>
    <message>
        <source>Validated to {depth:.1f} mm deep, the thickness of its wall.</source>
        <translation>{depth:.1f} mm derine kadar doğrulandı: duvarının kalınlığı.</translation>
    </message>
    <message>
        <source>Validated to {depth:.1f} mm deep.</source>
        <translation>{depth:.1f} mm derine kadar doğrulandı.</translation>
    </message>
    <message>
        <source>What it has now does not come to the end of the held-out presses.</source>
        <translation>Şimdiki, ayrı tutulan basmaların sonuna varmıyor.</translation>
    </message>
    <message>
        <source>What it has now is {held:.1%} off on the held-out presses.</source>
        <translation>Şimdiki, ayrı tutulan basmalarda {held:.1%} sapar.</translation>
    </message>
    <message>
        <source>a force {error:.1%} off</source>
        <translation>{error:.1%} sapan kuvvet</translation>
    </message>
    <message>
        <source>a shape that nobody looked at</source>
        <translation>bakılmamış biçim</translation>
    </message>
    <message>
        <source>a shape {error:.1%} off</source>
        <translation>{error:.1%} sapan biçim</translation>
    </message>
    <message>
        <source>steps {times:.2g} times too long</source>
        <translation>{times:.2g} kat uzun adımlar</translation>
    </message>
    <message>
        <source>ticks {times:.2g} times too long</source>
        <translation>{times:.2g} kat uzun süren adımlar</translation>
    </message>
    <message>
        <source>{factor:g} times the p99 of a tick in touch is {value:.3g} µs, of {allowed:.4g} µs allowed.</source>
        <translation>Temasta bir adımın p99 değerinin {factor:g} katı {value:.3g} µs; izin verilen {allowed:.4g} µs.</translation>
    </message>
    <message>
        <source>On one press held out from the choice its force is {held:.1%} off, where the chart has {charted:.1%}; the truth is known to {truth:.1%} there, to {own:.1%} on the chart.</source>
        <translation>Seçimden ayrı tutulan bir basmada kuvveti {held:.1%} sapar, çizelgede {charted:.1%}; gerçek orada {truth:.1%}, çizelgede {own:.1%} ile bilinir.</translation>
    </message>
    <message>
        <source>{law}</source>
        <translation>{law}</translation>
    </message>
    <message>
        <source>it cannot be built yet: {problem}</source>
        <translation>henüz kurulamıyor: {problem}</translation>
    </message>
    <message>
        <source>it ticks too slowly to be pressed here</source>
        <translation>burada bastırılamayacak kadar yavaş adım atıyor</translation>
    </message>
    <message>
        <source>it is too small to be pressed</source>
        <translation>bastırılamayacak kadar küçük</translation>
    </message>
    <message>
        <source>Filling: as fine everywhere</source>
        <translation>Dolgu: her yerde aynı incelikte</translation>
    </message>
    <message>
        <source>Filling finer at {region}</source>
        <translation>{region} bölgesinde daha ince dolgu</translation>
    </message>
    <message>
        <source>a ball has no shaft that would pass a trocar</source>
        <translation>kürenin trokardan geçecek bir sapı yoktur</translation>
    </message>
    <message>
        <source>It counts where the length that touches is above 0.</source>
        <translation>Dokunan uzunluk 0'dan büyükse geçerlidir.</translation>
    </message>
    <message>
        <source>a ball has no jaws</source>
        <translation>kürenin çenesi yoktur</translation>
    </message>
    <message>
        <source>what has no jaws closes on nothing</source>
        <translation>çenesi olmayan hiçbir şeyi kavramaz</translation>
    </message>
    <message>
        <source>It counts where jaws open.</source>
        <translation>Çeneler açılıyorsa geçerlidir.</translation>
    </message>
    <message>
        <source>tetrahedra are of one size</source>
        <translation>dörtyüzlüler tek boyda</translation>
    </message>
    <message>
        <source>It counts where a region is filled finer.</source>
        <translation>Bir bölge daha ince doldurulduğunda geçerlidir.</translation>
    </message>
    <message>
        <source>{old} triangles, now {new}</source>
        <translation>{old} üçgen, şimdi {new}</translation>
    </message>
    <message>
        <source>{old} pieces, now {new}</source>
        <translation>{old} parça, şimdi {new}</translation>
    </message>
    <message>
        <source>{old} holes, now {new}</source>
        <translation>{old} delik, şimdi {new}</translation>
    </message>
    <message>
        <source>{old} edges with more than two triangles, now {new}</source>
        <translation>ikiden çok üçgeni olan {old} kenar, şimdi {new}</translation>
    </message>
    <message>
        <source>{old} triangles that cross others, now {new}</source>
        <translation>başkalarıyla kesişen {old} üçgen, şimdi {new}</translation>
    </message>
    <message>
        <source>{new} triangles that cross others, too many to count before</source>
        <translation>başkalarıyla kesişen {new} üçgen, önceden sayılamayacak kadar çoktu</translation>
    </message>
    <message>
        <source>volume {old:.4g} to {new:.4g} ml ({share:+.2f} %)</source>
        <translation>hacim {old:.4g} ml'den {new:.4g} ml'ye (%{share:+.2f})</translation>
    </message>
    <message>
        <source>closed now, volume {new:.4g} ml</source>
        <translation>artık kapalı, hacim {new:.4g} ml</translation>
    </message>
    <message>
        <source>no point further than {to:.3g} mm from the surface before, nor it than {back:.3g} mm from the new one</source>
        <translation>hiçbir nokta önceki yüzeyden {to:.3g} mm'den, önceki yüzey de yenisinden {back:.3g} mm'den uzak değil</translation>
    </message>
    <message>
        <source>no point further than {to:.3g} mm from the surface before, and nothing that was seen of that from outside further than {back:.3g} mm from the new one; what lay inside is gone</source>
        <translation>hiçbir nokta önceki yüzeyden {to:.3g} mm'den, onun dışarıdan görünen hiçbir yeri de yenisinden {back:.3g} mm'den uzak değil; içeride kalanlar gitti</translation>
    </message>
    <message>
        <source>The surface is clean already.</source>
        <translation>Yüzey zaten temiz.</translation>
    </message>
    <message>
        <source>Borders are stitched that are more than 0 mm apart at most, got {got:g} mm.</source>
        <translation>Dikilecek sınırların en büyük aralığı 0 mm'den büyük olmalı; verilen {got:g} mm.</translation>
    </message>
    <message>
        <source>No two borders lie on each other.</source>
        <translation>Üst üste gelen iki sınır yok.</translation>
    </message>
    <message>
        <source>The share of the area must be between 0 and 1, got {got:g}.</source>
        <translation>Alanın payı 0 ile 1 arasında olmalı; verilen {got:g}.</translation>
    </message>
    <message>
        <source>No piece of it is so small.</source>
        <translation>Bu kadar küçük bir parçası yok.</translation>
    </message>
    <message>
        <source>Smooth, {steps} steps</source>
        <translation>Pürüzsüzleştir, {steps} adım</translation>
    </message>
    <message>
        <source>Steps of smoothing: got {got}, expected 1 to {most}.</source>
        <translation>Pürüzsüzleştirme adımları: verilen {got}, olması gereken 1 ile {most} arası.</translation>
    </message>
    <message>
        <source>It cannot be smoothed yet: {why}</source>
        <translation>Henüz pürüzsüzleştirilemez: {why}</translation>
    </message>
    <message>
        <source>Smoothed by {steps} steps the surface would cross itself: take fewer.</source>
        <translation>{steps} adım pürüzsüzleştirilince yüzey kendini keserdi: daha az adım alın.</translation>
    </message>
    <message>
        <source>The time must be more than 0 s, got {got:g} s.</source>
        <translation>Süre 0 s'den büyük olmalı; verilen {got:g} s.</translation>
    </message>
    <message>
        <source>Crossings are removed once each edge has two triangles that agree.</source>
        <translation>Kesişmeler, her kenarın birbiriyle anlaşan iki üçgeni olunca giderilir.</translation>
    </message>
    <message>
        <source>The surface does not cross itself.</source>
        <translation>Yüzey kendini kesmiyor.</translation>
    </message>
    <message>
        <source>Crossings stay: {why}</source>
        <translation>Kesişmeler kalıyor: {why}</translation>
    </message>
    <message>
        <source>Nothing helped in the time: so many triangles lie on top of each other that they cannot be counted.</source>
        <translation>Bu sürede hiçbir şey işe yaramadı: o kadar çok üçgen üst üste ki sayılamıyor.</translation>
    </message>
    <message>
        <source>{count} triangles still cross others, at {places} mm; none of them could be replaced without another crossing, or in the time.</source>
        <translation>{count} üçgen hâlâ başkalarıyla kesişiyor, yerleri {places} mm; hiçbiri yeni bir kesişme olmadan ya da bu sürede değiştirilemedi.</translation>
    </message>
    <message>
        <source>It cannot be wrapped: {why}</source>
        <translation>Sarılamıyor: {why}</translation>
    </message>
    <message>
        <source>A wrap by a ball of {alpha:.3g} mm was not finished in {seconds:g} s: take a larger one.</source>
        <translation>{alpha:.3g} mm'lik bir küreyle sarma {seconds:g} s içinde bitmedi: daha büyüğünü alın.</translation>
    </message>
    <message>
        <source>Remesh to edges of {edge:.3g} mm</source>
        <translation>{edge:.3g} mm kenarlarla yeniden ağla</translation>
    </message>
    <message>
        <source>Remesh to edges of {edge:.3g} mm, {fine:.3g} mm in {region}</source>
        <translation>{edge:.3g} mm kenarlarla yeniden ağla, {region} bölgesinde {fine:.3g} mm</translation>
    </message>
    <message>
        <source>It cannot be remeshed before its surface is repaired.</source>
        <translation>Onar aşaması yüzeyini onarmadan yeniden ağlanamaz.</translation>
    </message>
    <message>
        <source>Edges must be longer than 0 mm, got {got:g} mm.</source>
        <translation>Kenarlar 0 mm'den uzun olmalı; verilen {got:g} mm.</translation>
    </message>
    <message>
        <source>The organ has no region '{name}'.</source>
        <translation>Organın '{name}' adlı bir bölgesi yok.</translation>
    </message>
    <message>
        <source>How long edges are in the region was not said.</source>
        <translation>Bölgedeki kenarların ne kadar uzun olacağı söylenmedi.</translation>
    </message>
    <message>
        <source>Edges in a region: got {got:g} mm, expected more than 0 mm and less than {most:g} mm, those of the rest.</source>
        <translation>Bir bölgedeki kenarlar: verilen {got:g} mm, olması gereken 0 mm'den çok ve kalanlarınki olan {most:g} mm'den az.</translation>
    </message>
    <message>
        <source>It cannot be remeshed: {why}</source>
        <translation>Yeniden ağlanamıyor: {why}</translation>
    </message>
    <message>
        <source>Remeshing was not finished in {seconds:g} s: longer edges take less.</source>
        <translation>Yeniden ağlama {seconds:g} s içinde bitmedi: daha uzun kenarlar daha az sürer.</translation>
    </message>
    <message>
        <source>With edges of {edge:.3g} mm {count} triangles would cross others: take shorter ones, or remove crossings first.</source>
        <translation>{edge:.3g} mm kenarlarla {count} üçgen başkalarıyla kesişirdi: daha kısasını alın ya da önce kesişmeleri giderin.</translation>
    </message>
    <message>
        <source>{count} holes that are no damage: a hollow organ or a sheet has them</source>
        <translation>hasar olmayan {count} delik: içi boş bir organda ya da bir tabakada bulunur</translation>
    </message>
    <message>
        <source>{count} small holes that no patch fits: it would touch another hole or the surface</source>
        <translation>hiçbir yamanın uymadığı {count} küçük delik: yama başka bir deliğe ya da yüzeye değerdi</translation>
    </message>
    <message>
        <source>There is nothing to repair that can be.</source>
        <translation>Onarılabilecek bir şey yok.</translation>
    </message>
    <message>
        <source>Nothing stands on it that ends freely.</source>
        <translation>Üzerinde duran ve serbest biten bir şey yok.</translation>
    </message>
    <message>
        <source>The holes cannot be filled: {why}</source>
        <translation>Delikler doldurulamıyor: {why}</translation>
    </message>
    <message>
        <source>Decimate to {count} vertices, within {error:g} mm</source>
        <translation>{count} köşeye indir, {error:g} mm içinde</translation>
    </message>
    <message>
        <source>{count} vertices are {found:.4g} mm from the source, not within {error:g} mm.</source>
        <translation>{count} köşe kaynaktan {found:.4g} mm uzak, {error:g} mm içinde değil.</translation>
    </message>
    <message>
        <source>The error must be more than 0 mm, got {got:g}.</source>
        <translation>Hata 0 mm'den fazla olmalı, verilen {got:g}.</translation>
    </message>
    <message>
        <source>No coarser surface is within {error:g} mm of it: use the imported one.</source>
        <translation>Daha kaba hiçbir yüzey {error:g} mm içinde kalmıyor: içe aktarılanı kullanın.</translation>
    </message>
    <message>
        <source>at least {least:g}: decimate it</source>
        <translation>en az {least:g}: seyreltin</translation>
    </message>
    <message>
        <source>at least {least:g}: keep more vertices</source>
        <translation>en az {least:g}: daha çok köşe bırakın</translation>
    </message>
    <message>
        <source>{distance:.2f} mm from the source</source>
        <translation>kaynaktan {distance:.2f} mm</translation>
    </message>
    <message>
        <source>at most {most:.2f} mm, {share:.0%} of its size: keep more vertices</source>
        <translation>en çok {most:.2f} mm, boyunun {share:.0%} kadarı: daha çok köşe bırakın</translation>
    </message>
    <message>
        <source>Decimate to {count} vertices, within {error:g} mm</source>
        <translation>{count} köşeye indir, {error:g} mm içinde</translation>
    </message>
    <message>
        <source>Far field of a finer mesh</source>
        <translation>Daha ince bir ağın uzak alanı</translation>
    </message>
    <message>
        <source>Far field of the mesh</source>
        <translation>Ağın kendi uzak alanı</translation>
    </message>
    <message>
        <source>Only a solid with contact as on tissue, without a wall, has a far field.</source>
        <translation>Yalnızca teması doku gibi olan, duvarsız dolu bir organın uzak alanı vardır.</translation>
    </message>
    <message>
        <source>The far field has not been solved for this surface yet: solve it first.</source>
        <translation>Uzak alan bu yüzey için henüz çözülmedi: önce çözün.</translation>
    </message>
    <message>
        <source>The far field has {got} numbers, expected {count}, six per vertex.</source>
        <translation>Uzak alanda {got} sayı var, köşe başına altı olmak üzere {count} bekleniyordu.</translation>
    </message>
    <message>
        <source>The far field is that of a finer mesh already.</source>
        <translation>Uzak alan zaten daha ince bir ağınki.</translation>
    </message>
    <message>
        <source>The far field is that of the mesh already.</source>
        <translation>Uzak alan zaten ağın kendisininki.</translation>
    </message>
    <message>
        <source>about {asked}: it was filled by an estimate; ask for a number again, and they are counted</source>
        <translation>yaklaşık {asked}: bir tahminle dolduruldu; yeniden bir sayı isteyin, o zaman sayılırlar</translation>
    </message>
    <message>
        <source>about {asked}; what is thin takes more than a few</source>
        <translation>yaklaşık {asked}; ince olan şey az sayıyla dolmaz</translation>
    </message>
    <message>
        <source>fine far field</source>
        <translation>ince uzak alan</translation>
    </message>
    <message>
        <source>one that was solved before the surface, what is held or painted, or Poisson's ratio was changed: that of these tetrahedra is felt</source>
        <translation>yüzey, tutulan ya da boyanan yerler veya Poisson oranı değişmeden önce çözülmüş olan: bu dörtyüzlülerinki hissediliyor</translation>
    </message>
    <message>
        <source>one that was solved on a finer mesh, in seconds: it costs a tick nothing</source>
        <translation>daha ince bir ağda saniyeler içinde çözülmüş olan: bir adıma yükü yoktur</translation>
    </message>
    <message>
        <source>that of these tetrahedra, stiffer than tissue where they are large</source>
        <translation>bu dörtyüzlülerinki; büyük oldukları yerde dokudan serttir</translation>
    </message>
    <message>
        <source>{problem}</source>
        <translation>{problem}</translation>
    </message>
    <message>
        <source>No piece of the surface lies inside of others.</source>
        <translation>Yüzeyin hiçbir parçası ötekilerin içinde değil.</translation>
    </message>
    <message>
        <source>each once: importing removes the others</source>
        <translation>her biri bir kez: içe aktarma ötekileri kaldırır</translation>
    </message>
    <message>
        <source>more vertices, or a wall of a thickness (Material)</source>
        <translation>daha çok köşe ya da kalınlığı olan bir duvar (Malzeme)</translation>
    </message>
    <message>
        <source>one outside: importing turns triangles until neighbours agree, where they can</source>
        <translation>tek bir dış taraf: içe aktarma, komşular olabildiğince uyuşana dek üçgenleri çevirir</translation>
    </message>
    <message>
        <source>outwards: importing turns them</source>
        <translation>dışa: içe aktarma çevirir</translation>
    </message>
    <message>
        <source>parts thinner than half of their triangles' edges under {share:.0%} of them, {thinnest:.2g} mm at the thinnest</source>
        <translation>üçgenlerin {share:.0%} kadarının altında, kenarlarının yarısından ince yerler; en incesi {thinnest:.2g} mm</translation>
    </message>
    <message>
        <source>surfaces that hang together by edges: importing parts them there</source>
        <translation>kenarlarla bağlı yüzeyler: içe aktarma onları orada ayırır</translation>
    </message>
    <message>
        <source>the outer surface alone, which is what is touched</source>
        <translation>yalnız dış yüzey: dokunulan odur</translation>
    </message>
    <message>
        <source>triangles that have an area: importing flips these away or removes them</source>
        <translation>alanı olan üçgenler: içe aktarma bunları çevirip giderir ya da kaldırır</translation>
    </message>
    <message>
        <source>{count} edges at which neighbours face different sides</source>
        <translation>komşuların ayrı taraflara baktığı {count} kenar</translation>
    </message>
    <message>
        <source>{count} pieces inside others, not seen from outside; {doubled} of them face outwards too: they count twice in the volume and are filled hollow</source>
        <translation>ötekilerin içinde, dışarıdan görünmeyen {count} parça; {doubled} tanesi de dışa bakıyor: hacimde iki kez sayılır ve içi boş doldurulur</translation>
    </message>
    <message>
        <source>{count} pieces inside others, not seen from outside</source>
        <translation>ötekilerin içinde, dışarıdan görünmeyen {count} parça</translation>
    </message>
    <message>
        <source>{count} points where surfaces touch and no edge is shared</source>
        <translation>yüzeylerin değdiği ama kenar paylaşmadığı {count} nokta</translation>
    </message>
    <message>
        <source>{count} triangles of no height</source>
        <translation>yüksekliği olmayan {count} üçgen</translation>
    </message>
    <message>
        <source>{count} triangles that are there twice</source>
        <translation>iki kez bulunan {count} üçgen</translation>
    </message>
    <message>
        <source>a closed surface, or the wall of {wall:g} mm that it has now (Material)</source>
        <translation>kapalı bir yüzey ya da şu anki {wall:g} mm kalınlığındaki duvar (Malzeme)</translation>
    </message>
    <message>
        <source>Its surface came with {most} vertices, and {count} cannot be made of them.</source>
        <translation>Yüzeyi {most} köşeyle geldi; bunlardan {count} köşe yapılamaz.</translation>
    </message>
    <message>
        <source>Its tetrahedra came with its file, and stay as they are.</source>
        <translation>Dörtyüzlüleri dosyasıyla geldi ve oldukları gibi kalır.</translation>
    </message>
    <message>
        <source>The atlas has no step of {step} that holds for this model.</source>
        <translation>Atlasta bu model için {step} ile dayanan bir adım yok.</translation>
    </message>
    <message>
        <source>This scene: {used:.3g} of {limit:.3g} ms used, {count} steps a tick of {step}.</source>
        <translation>Bu sahne: {limit:.3g} ms sınırın {used:.3g} ms kadarı kullanılıyor, {step} ile bir vuruşta {count} adım.</translation>
    </message>
    <message>
        <source>{step} holds every step: this scene takes {used:.3g} ms.</source>
        <translation>{step} her adımda dayanır: bu sahne {used:.3g} ms adım atıyor.</translation>
    </message>
    <message>
        <source>{value}, which asks for {count} steps a tick, of {step:.2g} us at most: about {share:.0%} of the time there is</source>
        <translation>{value}; her adımda en çok {step:.2g} us’lik {count} alt adım ister: var olan zamanın yaklaşık {share:.0%} kadarı</translation>
    </message>
    <message>
        <source>{value}, with which a light touch ends the run</source>
        <translation>{value}; bununla hafif bir dokunuş çalışmayı bitiriyor</translation>
    </message>
    <message>
        <source>at most {limit}</source>
        <translation>en çok {limit}</translation>
    </message>
    <message>
        <source>at least {limit}</source>
        <translation>en az {limit}</translation>
    </message>
    <message>
        <source>at most {share:.0%}: fewer tetrahedra, or {name}: {limit}</source>
        <translation>en çok {share:.0%}: daha az dörtyüzlü ya da {name}: {limit}</translation>
    </message>
    <message>
        <source>at most {share:.0%}: fewer vertices, or {name}: {limit}</source>
        <translation>en çok {share:.0%}: daha az köşe ya da {name}: {limit}</translation>
    </message>
    <message>
        <source>a closed surface: close it for filling, or make it a wall</source>
        <translation>kapalı bir yüzey: doldurmak için kapatın ya da bir duvar yapın</translation>
    </message>
    <message>
        <source>a thinner wall, or a surface that is smoother there</source>
        <translation>daha ince bir duvar ya da orada daha düzgün bir yüzey</translation>
    </message>
    <message>
        <source>at least {least:g}: another number of tetrahedra, or a surface without a narrow edge there</source>
        <translation>en az {least:g}: başka sayıda dörtyüzlü ya da orada dar bir kenarı olmayan bir yüzey</translation>
    </message>
    <message>
        <source>faces of a tetrahedron at {angle:.1f} degrees to each other, at ({x:.0f}, {y:.0f}, {z:.0f}) mm</source>
        <translation>({x:.0f}, {y:.0f}, {z:.0f}) mm noktasında, yüzleri birbirine {angle:.1f} derece olan bir dörtyüzlü</translation>
    </message>
    <message>
        <source>{count} holes stay open: no patch fits them, so there is nothing to fill.</source>
        <translation>{count} delik açık kalıyor: onlara uyan bir yama yok, bu yüzden doldurulacak bir şey yok.</translation>
    </message>
    <message>
        <source>{wall:g} mm, for which {share:.1%} of the surface bends too closely or has the other side too near: the wall is {least:.0%} as thick there at least, and bends too easily</source>
        <translation>{wall:g} mm; yüzeyin {share:.1%} kadarı bunun için çok dar bükülüyor ya da öbür yüzü çok yakın: duvar orada en az {least:.0%} kalınlıkta ve fazla kolay bükülüyor</translation>
    </message>
    <message>
        <source>Change a parameter</source>
        <translation>Parametreyi değiştir</translation>
    </message>
    <message>
        <source>Change the levels</source>
        <translation>Düzeyleri değiştir</translation>
    </message>
    <message>
        <source>a task that careful hands finish, and idle or violent ones do not</source>
        <translation>dikkatli ellerin bitirdiği, hareketsiz ya da sert ellerin bitiremediği bir görev</translation>
    </message>
</context>
<context>
    <name>tissues</name>
    <message>
        <source>Calcium oxalate. It does not give: every vertex is held, so that it is felt as hard as hand and contact are. It cannot be moved; that waits for rigid bodies.</source>
        <translation>Kalsiyum oksalat. Esnemez: her köşesi tutulmuştur; el ve temas ne kadar sertse o kadar sert hissedilir. Hareket ettirilemez; bu, rijit cisimleri bekliyor.</translation>
    </message>
    <message>
        <source>Cortex under its capsule; the pelvis is several times stiffer, and is not told apart here.</source>
        <translation>Kapsülünün altındaki korteks; pelvis birkaç kat daha serttir ve burada ayrılmamıştır.</translation>
    </message>
    <message>
        <source>Healthy, perfused. Fibrosis stiffens it by a factor of up to ten.</source>
        <translation>Sağlıklı, kanlanan doku. Fibroz onu on kata kadar sertleştirir.</translation>
    </message>
    <message>
        <source>No organ: the first experiments' patch, of about the stiffness of a practice pad.</source>
        <translation>Organ değil: ilk deneylerin parçası; sertliği yaklaşık bir alıştırma pedininki kadar.</translation>
    </message>
    <message>
        <source>Published values differ by a factor of six between elastography devices.</source>
        <translation>Yayımlanmış değerler elastografi aygıtları arasında altı kat değişiyor.</translation>
    </message>
    <message>
        <source>Published values span three decades; the density is that of the wall and of half of what it holds.</source>
        <translation>Yayımlanmış değerler bin kata yayılıyor; yoğunluk, duvarın ve içindekinin yarısınınkidir.</translation>
    </message>
    <message>
        <source>The density is that of the wall and of the bile that moves with it.</source>
        <translation>Yoğunluk, duvarın ve onunla hareket eden safranınkidir.</translation>
    </message>
    <message>
        <source>bending of a stone of calcium oxalate monohydrate</source>
        <translation>kalsiyum oksalat monohidrat taşının eğilmesi</translation>
    </message>
    <message>
        <source>from a shear modulus of 0.637 kPa, E = 3 G</source>
        <translation>0,637 kPa kayma modülünden, E = 3 G</translation>
    </message>
    <message>
        <source>from a shear modulus of 1.8 +- 0.4 kPa, E = 3 G</source>
        <translation>1,8 ± 0,4 kPa kayma modülünden, E = 3 G</translation>
    </message>
    <message>
        <source>from a shear modulus of 85 +- 8.2 kPa of the wall, E = 3 G</source>
        <translation>duvarın 85 ± 8,2 kPa kayma modülünden, E = 3 G</translation>
    </message>
    <message>
        <source>indentation in vivo, pig</source>
        <translation>canlıda bastırma, domuz</translation>
    </message>
    <message>
        <source>indentation, pig, ex vivo</source>
        <translation>bastırma, domuz, canlı dışında</translation>
    </message>
    <message>
        <source>indentation: 0.27 MPa human right lobe in vivo, 4.0 MPa pig ex vivo; stiffens with strain</source>
        <translation>bastırma: canlıda insan sağ lobu 0,27 MPa, canlı dışında domuz 4,0 MPa; gerinimle sertleşir</translation>
    </message>
    <message>
        <source>of the wall alone</source>
        <translation>yalnız duvarın</translation>
    </message>
    <message>
        <source>secant of human strips pulled until they break: 0.5 and 0.7 MPa at 190 %</source>
        <translation>kopana dek çekilen insan şeritlerinin sekantı: % 190'da 0,5 ve 0,7 MPa</translation>
    </message>
    <message>
        <source>shear wave elastography in vivo</source>
        <translation>canlıda kayma dalgası elastografisi</translation>
    </message>
    <message>
        <source>shear wave elastography in vivo, 2.9 +- 1.8 kPa</source>
        <translation>canlıda kayma dalgası elastografisi, 2,9 ± 1,8 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography in vivo, 4.74 +- 0.91 kPa in 115</source>
        <translation>canlıda kayma dalgası elastografisi, 115 kişide 4,74 ± 0,91 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography in vivo, cortex, 5.0 +- 2.9 kPa</source>
        <translation>canlıda kayma dalgası elastografisi, korteks, 5,0 ± 2,9 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography in vivo, pelvis, 23.6 +- 5.4 kPa</source>
        <translation>canlıda kayma dalgası elastografisi, pelvis, 23,6 ± 5,4 kPa</translation>
    </message>
    <message>
        <source>silicone practice pads, by hardness</source>
        <translation>silikon alıştırma pedleri, sertlikten</translation>
    </message>
    <message>
        <source>speed of sound in plaster stones, said to cover natural ones</source>
        <translation>alçı taşlarda ses hızı; doğal taşları da kapsadığı söyleniyor</translation>
    </message>
    <message>
        <source>tables</source>
        <translation>tablolar</translation>
    </message>
    <message>
        <source>tables; 1060 is blood-rich tissue</source>
        <translation>tablolar; 1060 kanlı dokudur</translation>
    </message>
    <message>
        <source>ultrasound, fasting</source>
        <translation>ultrason, aç karnına</translation>
    </message>
    <message>
        <source>weighed plaster stones, said to cover natural ones</source>
        <translation>tartılmış alçı taşlar; doğal taşları da kapsadığı söyleniyor</translation>
    </message>
    <message>
        <source>what models assume: nearly incompressible</source>
        <translation>modellerin varsaydığı: neredeyse sıkıştırılamaz</translation>
    </message>
    <message>
        <source>0.1 to 100 Hz</source>
        <translation>0,1 ile 100 Hz</translation>
    </message>
    <message>
        <source>40 Hz</source>
        <translation>40 Hz</translation>
    </message>
    <message>
        <source>5 um/s</source>
        <translation>5 µm/s</translation>
    </message>
    <message>
        <source>50 Hz</source>
        <translation>50 Hz</translation>
    </message>
    <message>
        <source>Along its fibres; it stiffens where a limb stretches it.</source>
        <translation>Lifleri boyunca; kol ya da bacak gerdiğinde sertleşir.</translation>
    </message>
    <message>
        <source>At rest, in diastole; it stiffens with age and several times over with every beat.</source>
        <translation>Dinlenirken, diyastolde; yaşla ve her atışta birkaç kat sertleşir.</translation>
    </message>
    <message>
        <source>At rest; it stiffens several times over when it works, and along its fibres.</source>
        <translation>Dinlenirken; çalışırken ve lifleri boyunca birkaç kat serttir.</translation>
    </message>
    <message>
        <source>Devices differ; an inflamed one is several times as stiff.</source>
        <translation>Aygıtlar farklı ölçer; iltihaplısı birkaç kat serttir.</translation>
    </message>
    <message>
        <source>E = 2 (1 + nu) G, nu 0.45, of 1.14 to 1.83 kPa from breathed out to breathed in</source>
        <translation>E = 2 (1 + nu) G, nu 0,45; nefes verilmişten alınmışa 1,14 ile 1,83 kPa</translation>
    </message>
    <message>
        <source>E = 3 G of 1.20 +- 0.16 kPa, magnetic resonance elastography of 361 adults</source>
        <translation>E = 3 G, 1,20 +- 0,16 kPa, 361 yetişkinde manyetik rezonans elastografi</translation>
    </message>
    <message>
        <source>E = 3 G of 4.40 +- 0.71 kPa, magnetic resonance elastography of ten enlarged glands</source>
        <translation>E = 3 G, 4,40 +- 0,71 kPa, büyümüş on bezde manyetik rezonans elastografi</translation>
    </message>
    <message>
        <source>E = 3 G of 752 Pa, undeformed, magnetic resonance elastography of ten women</source>
        <translation>E = 3 G, 752 Pa, şekli bozulmadan, on kadında manyetik rezonans elastografi</translation>
    </message>
    <message>
        <source>E = 3 mu of 0.53 +- 0.31 kPa, confined indentation in a scanner, pig</source>
        <translation>E = 3 mu, 0,53 +- 0,31 kPa, tarayıcıda kısıtlanmış bastırma, domuz</translation>
    </message>
    <message>
        <source>E = 3 rho v^2 of 1.29 to 1.96 m/s, by view and wall, left ventricle in diastole</source>
        <translation>E = 3 rho v^2, görüntü ve duvara göre 1,29 ile 1,96 m/s, diyastolde sol karıncık</translation>
    </message>
    <message>
        <source>E = 3 rho v^2 of 1.9 to 9.9 m/s, sciatic nerve, review of 17 studies</source>
        <translation>E = 3 rho v^2, 1,9 ile 9,9 m/s, siyatik sinir, 17 çalışmanın derlemesi</translation>
    </message>
    <message>
        <source>Fat and gland by turns; how hard it is pressed beforehand changes the value.</source>
        <translation>Yer yer yağ, yer yer bez; önceden ne kadar bastırıldığı değeri değiştirir.</translation>
    </message>
    <message>
        <source>Full of air; it stiffens with every breath in, and it does give way in volume.</source>
        <translation>Hava dolu; her nefes alışta sertleşir ve hacmi de değişir.</translation>
    </message>
    <message>
        <source>Healthy; nodules are stiffer.</source>
        <translation>Sağlıklı; nodüller daha serttir.</translation>
    </message>
    <message>
        <source>It stiffens steeply where it is pressed.</source>
        <translation>Bastırıldığı yerde hızla sertleşir.</translation>
    </message>
    <message>
        <source>Moduli of the steep part of a tensile curve are ten times those of its secant.</source>
        <translation>Çekme eğrisinin dik bölümünün modülü kirişininkinin on katıdır.</translation>
    </message>
    <message>
        <source>No number was found that could be read in its source.</source>
        <translation>Kaynağında okunabilen bir sayı bulunamadı.</translation>
    </message>
    <message>
        <source>Not pregnant; pieces outside of the body are five to ten times as stiff.</source>
        <translation>Gebe değil; vücut dışındaki parçalar beş on kat serttir.</translation>
    </message>
    <message>
        <source>Of enlarged glands, which are what is operated on; cancer is stiffer.</source>
        <translation>Ameliyat edilen büyümüş bezlerin; kanser daha serttir.</translation>
    </message>
    <message>
        <source>Of strips of cadavers; a living bladder that fills slowly is far softer.</source>
        <translation>Kadavra şeritlerinin; yavaşça dolan canlı mesane çok daha yumuşaktır.</translation>
    </message>
    <message>
        <source>Published values span four decades, by place, direction and method.</source>
        <translation>Yayımlanmış değerler yere, yöne ve yönteme göre on bin kat değişir.</translation>
    </message>
    <message>
        <source>Slack; pulled along its fibres it is some ten thousand times as stiff.</source>
        <translation>Gevşekken; lifleri boyunca çekilince on bin kat kadar serttir.</translation>
    </message>
    <message>
        <source>So soft that its own weight deforms it; values of slow and fast loads differ tenfold.</source>
        <translation>Kendi ağırlığıyla şekli bozulacak kadar yumuşak; yavaş ve hızlı yüklerin değerleri on kat farklıdır.</translation>
    </message>
    <message>
        <source>The secant of a strip pulled until it breaks; at small strains it is softer.</source>
        <translation>Kopana dek çekilen bir şeridin kirişi; küçük uzamalarda daha yumuşaktır.</translation>
    </message>
    <message>
        <source>Young's modulus at the pressure of the living; without it the wall is several times softer.</source>
        <translation>Canlının basıncındaki Young modülü; basınçsız duvar birkaç kat yumuşaktır.</translation>
    </message>
    <message>
        <source>artery wall</source>
        <translation>atardamar duvarı</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>varsayım</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>dururken</translation>
    </message>
    <message>
        <source>bladder wall</source>
        <translation>mesane duvarı</translation>
    </message>
    <message>
        <source>brain</source>
        <translation>beyin</translation>
    </message>
    <message>
        <source>breast</source>
        <translation>meme</translation>
    </message>
    <message>
        <source>compression by 1 to 2 %, from slow to fast</source>
        <translation>yüzde 1 ile 2 sıkıştırma, yavaştan hızlıya</translation>
    </message>
    <message>
        <source>computed, with its blood</source>
        <translation>hesaplanmış, kanıyla birlikte</translation>
    </message>
    <message>
        <source>ex vivo</source>
        <translation>vücut dışında</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>yağ</translation>
    </message>
    <message>
        <source>from computed tomography</source>
        <translation>bilgisayarlı tomografiden</translation>
    </message>
    <message>
        <source>from computed tomography, with what it holds</source>
        <translation>bilgisayarlı tomografiden, içindekiyle birlikte</translation>
    </message>
    <message>
        <source>heart muscle</source>
        <translation>kalp kası</translation>
    </message>
    <message>
        <source>in vivo</source>
        <translation>canlıda</translation>
    </message>
    <message>
        <source>incremental modulus round the vessel at 100 mmHg, dog</source>
        <translation>100 mmHg altında damar çevresince artımlı modül, köpek</translation>
    </message>
    <message>
        <source>indentation by a flat punch, cow: grey matter 1.4, white matter 1.9 kPa</source>
        <translation>düz uçla bastırma, inek: gri madde 1,4, ak madde 1,9 kPa</translation>
    </message>
    <message>
        <source>indentation of small pieces of fat and gland, 3.25 +- 0.9 kPa</source>
        <translation>küçük yağ ve bez parçalarına bastırma, 3,25 +- 0,9 kPa</translation>
    </message>
    <message>
        <source>large bowel wall</source>
        <translation>kalın bağırsak duvarı</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>akciğer</translation>
    </message>
    <message>
        <source>of an aorta</source>
        <translation>bir aortun</translation>
    </message>
    <message>
        <source>pancreas</source>
        <translation>pankreas</translation>
    </message>
    <message>
        <source>peripheral nerve</source>
        <translation>çevresel sinir</translation>
    </message>
    <message>
        <source>prostate</source>
        <translation>prostat</translation>
    </message>
    <message>
        <source>review of tension, indentation, suction and torsion</source>
        <translation>çekme, bastırma, emme ve burmanın derlemesi</translation>
    </message>
    <message>
        <source>secant of strips across, pulled until they break: 0.9 MPa at 140 %</source>
        <translation>kopana dek çekilen enine şeritlerin kirişi: yüzde 140 uzamada 0,9 MPa</translation>
    </message>
    <message>
        <source>secant of strips across, pulled until they break: 0.9 MPa at 180 %</source>
        <translation>kopana dek çekilen enine şeritlerin kirişi: yüzde 180 uzamada 0,9 MPa</translation>
    </message>
    <message>
        <source>shear wave elastography of 127 adults, 10.97 +- 3.1 kPa</source>
        <translation>127 yetişkinde kayma dalgası elastografisi, 10,97 +- 3,1 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography of 27 women through the belly, 6.38 +- 2.59 kPa</source>
        <translation>27 kadında karından kayma dalgası elastografisi, 6,38 +- 2,59 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography of 50 healthy adults, three devices</source>
        <translation>50 sağlıklı yetişkinde kayma dalgası elastografisi, üç aygıt</translation>
    </message>
    <message>
        <source>shear wave elastography of the Achilles tendon, 51.5 +- 25.1 kPa</source>
        <translation>Aşil tendonunda kayma dalgası elastografisi, 51,5 +- 25,1 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography of the forearm of 90 adults, mean 14.8 kPa</source>
        <translation>90 yetişkinin ön kolunda kayma dalgası elastografisi, ortalama 14,8 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography of the gastrocnemius of 127 adults, 11.1 +- 4.1 kPa</source>
        <translation>127 yetişkinin baldır kasında kayma dalgası elastografisi, 11,1 +- 4,1 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography of the quadriceps of 27 women, 7.22 +- 1.24 kPa</source>
        <translation>27 kadının uyluk kasında kayma dalgası elastografisi, 7,22 +- 1,24 kPa</translation>
    </message>
    <message>
        <source>shear wave elastography, 4.8 +- 3 kPa</source>
        <translation>kayma dalgası elastografisi, 4,8 +- 3 kPa</translation>
    </message>
    <message>
        <source>shear waves</source>
        <translation>kayma dalgaları</translation>
    </message>
    <message>
        <source>skeletal muscle</source>
        <translation>iskelet kası</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>deri</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>yavaş</translation>
    </message>
    <message>
        <source>small bowel wall</source>
        <translation>ince bağırsak duvarı</translation>
    </message>
    <message>
        <source>static</source>
        <translation>durağan</translation>
    </message>
    <message>
        <source>table</source>
        <translation>çizelge</translation>
    </message>
    <message>
        <source>taken as the spinal cord's</source>
        <translation>omuriliğinki gibi alındı</translation>
    </message>
    <message>
        <source>tendon</source>
        <translation>tendon</translation>
    </message>
    <message>
        <source>tension of human rectum and sigmoid; 1.83 MPa of pig</source>
        <translation>insan rektum ve sigmoidinin çekilmesi; domuzda 1,83 MPa</translation>
    </message>
    <message>
        <source>tension of strips of 13 women, mean 1.9 MPa</source>
        <translation>13 kadından şeritlerin çekilmesi, ortalama 1,9 MPa</translation>
    </message>
    <message>
        <source>tension of strips of great saphenous veins of cadavers, by place; the abstract has no number</source>
        <translation>kadavraların büyük safen toplardamarından şeritlerin yerine göre çekilmesi; özette sayı yok</translation>
    </message>
    <message>
        <source>thyroid gland</source>
        <translation>tiroit bezi</translation>
    </message>
    <message>
        <source>transrectal shear wave elastography, mean of benign cores</source>
        <translation>rektumdan kayma dalgası elastografisi, iyi huylu örneklerin ortalaması</translation>
    </message>
    <message>
        <source>ultrasound</source>
        <translation>ultrason</translation>
    </message>
    <message>
        <source>ultrasound of 60 healthy adults, 2.85 +- 0.43 mm</source>
        <translation>60 sağlıklı yetişkinde ultrason, 2,85 +- 0,43 mm</translation>
    </message>
    <message>
        <source>ultrasound, distended</source>
        <translation>ultrason, gerilmişken</translation>
    </message>
    <message>
        <source>uterus</source>
        <translation>rahim</translation>
    </message>
    <message>
        <source>vein wall</source>
        <translation>toplardamar duvarı</translation>
    </message>
    <message>
        <source>what models assume: air is pressed out</source>
        <translation>modellerin varsaydığı: hava dışarı itilir</translation>
    </message>
</context>
</TS>
